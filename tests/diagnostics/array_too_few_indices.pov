#version 3.7;
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } }
#debug str(A[1], 0, 0)
//! error: this array has 2 dimensions, and here is 1 index
//!  --> array_too_few_indices.pov:3:12
//!   |
//! 3 | #debug str(A[1], 0, 0)
//!   |            ^^^^
