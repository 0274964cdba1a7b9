sphere { 0， 1 }
//! error: this is a wide comma
//!  --> comma_of_a_wide_alphabet.pov:1:11
//!   |
//! 1 | sphere { 0， 1 }
//!   |           ^
//! help: write `,`
