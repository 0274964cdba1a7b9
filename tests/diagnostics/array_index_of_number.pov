// SPDX-License-Identifier: GPL-3.0-or-later
// A number has no elements
#version 3.7;
#declare A = 3;
#declare B = A[0];
//! error: only arrays have elements, and this is a number
//!  --> array_index_of_number.pov:5:14
//!   |
//! 5 | #declare B = A[0];
//!   |              ^^^^
