#for (I, 0, 10)
  sphere { I*x, 0.5 }
#next
//! error: there is no directive `#next`
//!  --> next_as_in_basic.pov:3:1
//!   |
//! 3 | #next
//!   | ^^^^^
//! help: did you mean `#end`?
