#version 3.7;
#macro Sum(A, B = 2) A + B #end
//! error: expected a name, `)` or `,`, but found `=`
//!  --> macro_parameter_with_value.pov:2:17
//!   |
//! 2 | #macro Sum(A, B = 2) A + B #end
//!   |                 ^
//! help: a parameter that may be left out: #macro M(A, optional B) #ifndef (B) #local B = 2; #end ... #end
