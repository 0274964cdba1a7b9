#version 3.7;
#if (x > 3) #debug "more" #end
//! error: a condition must be a number, but it is a vector of 3
//!  --> axis_as_variable.pov:2:5
//!   |
//! 2 | #if (x > 3) #debug "more" #end
//!   |     ^^^^^^^
//! help: `x` is the vector <1, 0, 0>; `X` may be a name
