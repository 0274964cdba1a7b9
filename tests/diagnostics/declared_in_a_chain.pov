#declare A = B = 5;
//! error: `=` does not fit here
//!  --> declared_in_a_chain.pov:1:16
//!   |
//! 1 | #declare A = B = 5;
//!   |                ^
//! help: each name has its own #declare: #declare A = 1; #declare B = 1;
