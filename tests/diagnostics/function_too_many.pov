// SPDX-License-Identifier: GPL-3.0-or-later
// A function with too many arguments
#version 3.7;
#declare A = sin(1, 2);
//! error: `sin` takes 1 argument, but here are 2
//!  --> function_too_many.pov:4:14
//!   |
//! 4 | #declare A = sin(1, 2);
//!   |              ^^^^^^^^^
//! help: sin(x): sine of radians
