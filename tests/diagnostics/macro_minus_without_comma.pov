#macro M(A, B) sphere { A, B } #end
M(1 -2)
//! error: macro `M` takes 2 arguments, but here is 1
//!  --> macro_minus_without_comma.pov:2:1
//!   |
//! 1 | #macro M(A, B) sphere { A, B } #end
//!   | -------- defined as M(A, B)
//! 2 | M(1 -2)
//!   | ^^^^^^^
//! help: a value and a `-` behind it are one value: a comma keeps them apart
