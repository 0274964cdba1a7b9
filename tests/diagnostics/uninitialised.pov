// SPDX-License-Identifier: GPL-3.0-or-later
// An element of an array before it has a value
#version 3.7;
#declare Sizes = array[3];
#declare Sizes[0] = 1;
sphere { 0, Sizes[0] }
sphere { 0, Sizes[1] }
//! error: this element of the array was never set
//!  --> uninitialised.pov:7:13
//!   |
//! 7 | sphere { 0, Sizes[1] }
//!   |             ^^^^^^^^
