sphere(<0, 0, 0>, 1)
//! error: what belongs to `sphere` stands in braces
//!  --> sphere_in_parentheses.pov:1:1
//!   |
//! 1 | sphere(<0, 0, 0>, 1)
//!   | ^^^^^^
//! help: write `sphere { ... }`
