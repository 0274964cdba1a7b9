// SPDX-License-Identifier: GPL-3.0-or-later
// Things that are said twice
#version 3.7;
camera { location -z }
camera { location -2*z }
//! warning[duplicate]: there is a camera before this one; the last one counts
//!  --> duplicate.pov:5:1
//!   |
//! 5 | camera { location -2*z }
//!   | ^^^^^^
sphere { 0, 1 finish { ambient 0 diffuse 1 ambient 0.2 } }
//! warning[duplicate]: `ambient` of `finish` is given again; this one counts
//!  --> duplicate.pov:6:44
//!   |
//! 6 | sphere { 0, 1 finish { ambient 0 diffuse 1 ambient 0.2 } }
//!   |                                            ^^^^^^^
global_settings { light_sampler { linear_alpha light_octree } }
//! error: `light_sampler` has one strategy, and this is a second
//!  --> duplicate.pov:7:48
//!   |
//! 7 | global_settings { light_sampler { linear_alpha light_octree } }
//!   |                                                ^^^^^^^^^^^^
//! help: light_sampler { light_octree [threshold n] ... }, or one of: every_light, constant_alpha, linear_alpha, light_bvh
