#version 3.7;
#declare F = function (float X) { X*X }
//! error: `float` is no type here, but one more parameter
//!  --> function_parameter_with_type.pov:2:24
//!   |
//! 2 | #declare F = function (float X) { X*X }
//!   |                        ^^^^^
//! help: the parameters of a function are numbers, and only named: function(X, Y) { X*Y }
