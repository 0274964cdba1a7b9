light_source { <0, 10, 0>, rgb 1 spotlight target <0, 0, 0> }
//! error: `light_source` has no word `target`
//!  --> spotlight_target.pov:1:44
//!   |
//! 1 | light_source { <0, 10, 0>, rgb 1 spotlight target <0, 0, 0> }
//!   |                                            ^^^^^^
//! help: did you mean `point_at`?
