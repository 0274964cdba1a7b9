#version 2.0
#max_trace_level 10
//! warning[deprecated]: `max_trace_level` belongs into `global_settings`
//!  --> very_old_syntax.pov:2:2
//!   |
//! 2 | #max_trace_level 10
//!   |  ^^^^^^^^^^^^^^^
//! help: global_settings { max_trace_level 5 }
camera { location <0, 2, -8> look_at <0, 0.5, 0> }
object { light_source { <5, 8, -10> colour red 1 green 1 blue 1 } }
fog { colour red 0.5 green 0.5 blue 1  20 }
sphere { <0, 1, 0> 1 colour red 1 }
//! warning[no-effect]: `color` has no effect in `sphere`
//!  --> very_old_syntax.pov:6:22
//!   |
//! 6 | sphere { <0, 1, 0> 1 colour red 1 }
//!   |                      ^^^^^^^^^^^^
//! help: an object gets its colour from a pigment: pigment { color rgb <1, 0, 0> }
composite {
    object { sphere { <0, 1, 0> 1 } texture { pigment { colour red 1 } } }
    translate <1, 0, 0>
}
