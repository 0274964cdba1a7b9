#version 3,7;
//! error: a number is written with a point, not with a comma
//!  --> version_with_comma.pov:1:10
//!   |
//! 1 | #version 3,7;
//!   |          ^^^
//! help: write 3.7
