#declare A = array[3] { 1, 2, 3 }
A.push(4)
//! error: `.push` is a part of a vector or a colour, but this is an array
//!  --> array_with_method.pov:2:1
//!   |
//! 2 | A.push(4)
//!   | ^^^^^^
//! help: dimension_size(A, 1) is the size of an array
