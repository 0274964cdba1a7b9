sphere { <0, 1, 2>>, 1 }
//! error: `>` does not fit here
//!  --> vector_closed_twice.pov:1:19
//!   |
//! 1 | sphere { <0, 1, 2>>, 1 }
//!   |                   ^
//! help: one `>` ends the vector
