// SPDX-License-Identifier: GPL-3.0-or-later
// A condition without parentheses
#version 3.7;
#declare I = 2;
#if I > 1 sphere { 0, 1 } #end
//! error: expected `(`, but found `I`
//!  --> condition_without_parentheses.pov:5:5
//!   |
//! 5 | #if I > 1 sphere { 0, 1 } #end
//!   |     ^
//! help: a condition stands in parentheses: (a > b)
