#version 3.7;
#declare F = function (X) { if (X > 0) X else 0 };
//! error: `if` needs a # before it
//!  --> if_in_function.pov:2:29
//!   |
//! 2 | #declare F = function (X) { if (X > 0) X else 0 };
//!   |                             ^^
//! help: write `#if`
