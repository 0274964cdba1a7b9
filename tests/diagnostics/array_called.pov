// SPDX-License-Identifier: GPL-3.0-or-later
// An index in parentheses
#version 3.7;
#declare A = array[3] { 1, 2, 3 } #declare B = A(1);
//! error: `A` is an array and cannot be called
//!  --> array_called.pov:4:48
//!   |
//! 4 | #declare A = array[3] { 1, 2, 3 } #declare B = A(1);
//!   |                                                ^^^^
//! help: an element of it is written A[0]
