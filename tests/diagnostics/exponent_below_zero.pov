// SPDX-License-Identifier: GPL-3.0-or-later
// Values out of their range
#version 3.7;
#declare Gauge = 3;
superellipsoid { <Gauge - 5, 1> }
//! warning[no-effect]: `exponents` of `superellipsoid` should be above 0, but it is -2: 0.001 counts
//!  --> exponent_below_zero.pov:5:18
//!   |
//! 5 | superellipsoid { <Gauge - 5, 1> }
//!   |                  ^^^^^^^^^^^^^^
//! help: superellipsoid { exponents }   exponents: vector of 2 above 0
sphere { 0, 1 finish { roughness 0 } }
//! warning[no-effect]: `roughness` of `finish` should be above 0, but it is 0: 0.0001 counts
//!  --> exponent_below_zero.pov:6:34
//!   |
//! 6 | sphere { 0, 1 finish { roughness 0 } }
//!   |                                  ^
//! help: finish { ... roughness n ... }   roughness: number above 0, default 0.05
global_settings { max_trace_level 1000 }
//! warning[no-effect]: `max_trace_level` of `global_settings` should be from 0 to 256, but it is 1000: 256 counts
//!  --> exponent_below_zero.pov:7:35
//!   |
//! 7 | global_settings { max_trace_level 1000 }
//!   |                                   ^^^^
//! help: global_settings { ... max_trace_level n ... }   max_trace_level: whole number from 0 to 256, default 5
