// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a light sampler that have no effect with the others
#version 3.7;
global_settings { light_sampler { light_octree { threshold 0.01 cut 32 } } }
//! warning[no-effect]: `threshold` of `light_octree` has no effect without `paper`
//!  --> sampler_idle.pov:4:35
//!   |
//! 4 | global_settings { light_sampler { light_octree { threshold 0.01 cut 32 } } }
//!   |                                   ^^^^^^^^^^^^
