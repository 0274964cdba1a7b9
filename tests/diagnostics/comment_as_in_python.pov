# this is a comment
//! error: there is no directive `#this`
//!  --> comment_as_in_python.pov:1:1
//!   |
//! 1 | # this is a comment
//!   | ^^^^^^
//! help: a comment begins with `//`
sphere { 0, 1 }
