#declare S = spline { linear_spline 0, <0, 0, 0>, 1, <1, 0, 0> }
sphere { S[0.5], 1 }
//! error: only arrays have elements, and this is a spline
//!  --> spline_in_brackets.pov:2:10
//!   |
//! 2 | sphere { S[0.5], 1 }
//!   |          ^^^^^^
//! help: the value of a spline S is written S(0.5)
