# don't do this
//! error: there is no directive `#don`
//!  --> comment_with_apostrophe.pov:1:1
//!   |
//! 1 | # don't do this
//!   | ^^^^^
//! help: a comment begins with `//`
sphere { 0, 1 }
