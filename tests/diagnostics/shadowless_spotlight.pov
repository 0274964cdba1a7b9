#version 3.7;
camera { location <0, 1, -5> look_at 0 }
light_source { <2, 4, -3> rgb 1 spotlight point_at 0 radius 10 falloff 20 shadowless }
//! warning[no-effect]: `spotlight` has no effect: a `shadowless` light shines all around
//!  --> shadowless_spotlight.pov:3:1
//!   |
//! 3 | light_source { <2, 4, -3> rgb 1 spotlight point_at 0 radius 10 falloff 20 shadowless }
//!   | ^^^^^^^^^^^^
light_source { <-2, 4, -3> rgb 1 cylinder point_at 0 shadowless }
//! warning[no-effect]: `cylinder` gives no edge to a `shadowless` light, which shines everywhere
//!  --> shadowless_spotlight.pov:4:1
//!   |
//! 4 | light_source { <-2, 4, -3> rgb 1 cylinder point_at 0 shadowless }
//!   | ^^^^^^^^^^^^
sphere { 0, 1 pigment { rgb 1 } }
