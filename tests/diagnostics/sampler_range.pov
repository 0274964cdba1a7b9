// SPDX-License-Identifier: GPL-3.0-or-later
// A setting out of range
#version 3.7;
global_settings { light_sampler { light_octree { threshold -1 } } }
//! error: `threshold` of `light_octree` must be above 0, but it is -1
//!  --> sampler_range.pov:4:60
//!   |
//! 4 | global_settings { light_sampler { light_octree { threshold -1 } } }
//!   |                                                            ^^ this is -1
//! help: light_octree { ... threshold n ... }   threshold: number above 0, default 0.0007
