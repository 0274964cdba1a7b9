#version 3.7;
global_settings { charset utf8 }
//! warning[no-effect]: `charset` has no effect in this version
//!  --> charset_of_strings.pov:2:19
//!   |
//! 2 | global_settings { charset utf8 }
//!   |                   ^^^^^^^
#declare Name = "café";
