#version 3.7;
sphere { 0, 1 pigment { color "red" } }
//! error: a colour is wanted, but this is the string "red"
//!  --> colour_in_quotes.pov:2:25
//!   |
//! 2 | sphere { 0, 1 pigment { color "red" } }
//!   |                         ^^^^^^^^^^^
//! help: colours have names without quotes: Red, in colors.inc; in a table they are written as #ff8800
