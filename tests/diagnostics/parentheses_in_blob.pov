blob { threshold 0.5 sphere { 0, 1, 1 } sphere (<1, 0, 0>, 1, 1) }
//! error: values in parentheses are no vector
//!  --> parentheses_in_blob.pov:1:48
//!   |
//! 1 | blob { threshold 0.5 sphere { 0, 1, 1 } sphere (<1, 0, 0>, 1, 1) }
//!   |                                                ^^^^^^^^^^^^^^^^^
//! help: a vector is written between `<` and `>`, and what belongs to an object in braces: <1, 2, 3>, sphere { ... }
