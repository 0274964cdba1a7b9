#for (I, 0..9)
//! error: a number has only one point
//!  --> range_as_in_pascal.pov:1:10
//!   |
//! 1 | #for (I, 0..9)
//!   |          ^^^^
//! help: from one number to another is written with a comma: #for (I, 0, 9)
sphere { I*x, 1 }
#end
