// SPDX-License-Identifier: GPL-3.0-or-later
// #declare F(X) = X*2;
#version 3.7;
#declare F(X) = X*2;
//! error: expected `=`, but found `(`
//!  --> function_as_in_mathematics.pov:4:11
//!   |
//! 4 | #declare F(X) = X*2;
//!   |           ^
//! help: a function is written #declare F = function(X) { ... };, and what gives other than numbers is a macro
