#declare A = 2*π;
//! error: this is a Greek letter
//!  --> greek_letter.pov:1:16
//!   |
//! 1 | #declare A = 2*π;
//!   |                ^
//! help: write `pi`
