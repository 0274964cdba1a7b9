// SPDX-License-Identifier: GPL-3.0-or-later
// A component that has no such name
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.w;
//! error: a vector or a colour has no part `.w`
//!  --> dot_misspelt.pov:5:14
//!   |
//! 5 | #declare A = V.w;
//!   |              ^^^
//! help: parts are x y z t, u v, red green blue filter transmit, gray
