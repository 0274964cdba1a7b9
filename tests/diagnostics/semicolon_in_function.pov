#version 3.7;
#declare F = function (X) { X*X; }
//! error: expected `}`, but found `;`
//!  --> semicolon_in_function.pov:2:32
//!   |
//! 2 | #declare F = function (X) { X*X; }
//!   |                                ^
//! help: a function is one expression, without `;`
