#version 3.7;
#global_settings { assumed_gamma 1 }
//! warning[syntax]: this `#` has no effect, for `global_settings` is no directive
//!  --> hash_before_block.pov:2:1
//!   |
//! 2 | #global_settings { assumed_gamma 1 }
//!   | ^
camera { location <0, 0, -3> look_at 0 }
#light_source { <2, 4, -3> rgb 1 }
//! warning[syntax]: this `#` has no effect, for `light_source` is no directive
//!  --> hash_before_block.pov:4:1
//!   |
//! 4 | #light_source { <2, 4, -3> rgb 1 }
//!   | ^
sphere { 0, 1 #pigment { rgb 1 } }
//! warning[syntax]: this `#` has no effect, for `pigment` is no directive
//!  --> hash_before_block.pov:5:15
//!   |
//! 5 | sphere { 0, 1 #pigment { rgb 1 } }
//!   |               ^
