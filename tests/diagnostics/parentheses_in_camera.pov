camera { cylinder (1, 2, 3) }
//! error: values in parentheses are no vector
//!  --> parentheses_in_camera.pov:1:19
//!   |
//! 1 | camera { cylinder (1, 2, 3) }
//!   |                   ^^^^^^^^^
//! help: a vector is written between `<` and `>`, and what belongs to an object in braces: <1, 2, 3>, cylinder { ... }
