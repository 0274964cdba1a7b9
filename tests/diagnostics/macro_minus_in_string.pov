#macro M(A, B) text { ttf "timrom.ttf" A B, 0 } #end
M("x -y")
//! error: macro `M` takes 2 arguments, but here is 1
//!  --> macro_minus_in_string.pov:2:1
//!   |
//! 1 | #macro M(A, B) text { ttf "timrom.ttf" A B, 0 } #end
//!   | -------- defined as M(A, B)
//! 2 | M("x -y")
//!   | ^^^^^^^^^
