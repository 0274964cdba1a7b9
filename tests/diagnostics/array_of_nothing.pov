// SPDX-License-Identifier: GPL-3.0-or-later
// An array of size 0
#version 3.7;
#declare A = array[0];
//! error: the size of an array must be at least 1, but it is 0
//!  --> array_of_nothing.pov:4:20
//!   |
//! 4 | #declare A = array[0];
//!   |                    ^
