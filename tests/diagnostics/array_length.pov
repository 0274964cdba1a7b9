// SPDX-License-Identifier: GPL-3.0-or-later
// The size of an array as in other languages
#version 3.7;
#declare A = array[3] {1,2,3} #declare N = A.length;
//! error: `.length` is a part of a vector or a colour, but this is an array
//!  --> array_length.pov:4:44
//!   |
//! 4 | #declare A = array[3] {1,2,3} #declare N = A.length;
//!   |                                            ^^^^^^^^
//! help: dimension_size(A, 1) is the size of an array
