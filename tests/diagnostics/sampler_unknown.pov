// SPDX-License-Identifier: GPL-3.0-or-later
// A light sampler that does not exist
#version 3.7;
global_settings { light_sampler { light_tree } }
//! error: `light_sampler` has no word `light_tree`
//!  --> sampler_unknown.pov:4:35
//!   |
//! 4 | global_settings { light_sampler { light_tree } }
//!   |                                   ^^^^^^^^^^
//! help: did you mean `light_octree`?
