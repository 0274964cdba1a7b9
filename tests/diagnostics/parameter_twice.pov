#macro M(a, b, a) a + b #end
//! error: a second parameter is called `a`
//!  --> parameter_twice.pov:1:16
//!   |
//! 1 | #macro M(a, b, a) a + b #end
//!   |          -     ^
//!   |          |
//!   |          the first
//! help: the parameters of a macro have different names
