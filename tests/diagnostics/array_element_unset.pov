// SPDX-License-Identifier: GPL-3.0-or-later
// An element that was never set
#version 3.7;
#declare A = array[3];
sphere { 0, A[1] }
//! error: this element of the array was never set
//!  --> array_element_unset.pov:5:13
//!   |
//! 5 | sphere { 0, A[1] }
//!   |             ^^^^
