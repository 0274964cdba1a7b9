// SPDX-License-Identifier: GPL-3.0-or-later
// #declare A = [1, 2, 3];
#version 3.7;
#declare A = [1, 2, 3];
//! error: expected a value, but found `[`
//!  --> array_by_brackets.pov:4:14
//!   |
//! 4 | #declare A = [1, 2, 3];
//!   |              ^
//! help: an array is written array { 1, 2, 3 }
