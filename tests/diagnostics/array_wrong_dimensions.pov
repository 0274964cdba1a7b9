// SPDX-License-Identifier: GPL-3.0-or-later
// One index for two dimensions
#version 3.7;
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } }
#declare B = A[1];
//! error: this array has 2 dimensions, and here is 1 index
//!  --> array_wrong_dimensions.pov:5:14
//!   |
//! 5 | #declare B = A[1];
//!   |              ^^^^
