#declare A = 1;
#if (A <> 3) #end
//! error: expected a value, but found `>`
//!  --> not_equal_as_in_basic.pov:2:9
//!   |
//! 2 | #if (A <> 3) #end
//!   |         ^
//! help: `!=` is not equal: (a != b)
