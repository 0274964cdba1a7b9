#declare A = 5, B = 6;
//! error: `=` does not fit here
//!  --> declared_with_a_comma.pov:1:19
//!   |
//! 1 | #declare A = 5, B = 6;
//!   |                   ^
//! help: each name has its own #declare: #declare A = 1; #declare B = 1;
