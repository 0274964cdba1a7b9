light_source { 0, rgb 1 cylinder (1, 2, 3) }
//! error: values in parentheses are no vector
//!  --> parentheses_behind_cylinder.pov:1:34
//!   |
//! 1 | light_source { 0, rgb 1 cylinder (1, 2, 3) }
//!   |                                  ^^^^^^^^^
//! help: a vector is written between `<` and `>`, and what belongs to an object in braces: <1, 2, 3>, cylinder { ... }
