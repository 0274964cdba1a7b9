// SPDX-License-Identifier: GPL-3.0-or-later
// The size of an array by the wrong function
#version 3.7;
#declare A = array[3] {1,2,3} #declare N = length(A);
//! error: nothing is declared as `length`
//!  --> length_of_array.pov:4:44
//!   |
//! 4 | #declare A = array[3] {1,2,3} #declare N = length(A);
//!   |                                            ^^^^^^
//! help: the length of a string is strlen(S), of a vector vlength(V), of an array dimension_size(A, 1)
