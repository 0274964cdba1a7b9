#declare B[0] = 1;
//! error: there is no array `B`
//!  --> array_not_made.pov:1:10
//!   |
//! 1 | #declare B[0] = 1;
//!   |          ^^^^
//! help: make it first: #declare B = array[10];
