#declare A = array[2] { 1, 2 };
#declare A[1]: 3;
//! error: expected `=`, but found `:`
//!  --> colon_for_equals.pov:2:14
//!   |
//! 2 | #declare A[1]: 3;
//!   |              ^
