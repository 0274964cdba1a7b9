light_source { 0, rgb 1 spotlight target z }
//! error: `light_source` has no word `target`
//!  --> target_of_light.pov:1:35
//!   |
//! 1 | light_source { 0, rgb 1 spotlight target z }
//!   |                                   ^^^^^^
//! help: did you mean `point_at`?
