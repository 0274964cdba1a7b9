// SPDX-License-Identifier: GPL-3.0-or-later
// Words without their values, blocks without what they are for
#version 3.7;
sphere { 0, 1 translate rotate x }
//! error: `translate` of `sphere` needs a vector
//!  --> missing.pov:4:15
//!   |
//! 4 | sphere { 0, 1 translate rotate x }
//!   |               ^^^^^^^^^
//! help: sphere { ... translate v ... }   translate: vector, default 0
sphere { 0, 1 finish { reflection } }
//! error: `reflection` of `finish` needs a colour or a block
//!  --> missing.pov:5:24
//!   |
//! 5 | sphere { 0, 1 finish { reflection } }
//!   |                        ^^^^^^^^^^
//! help: reflection { minimum[, maximum] [fresnel] [falloff n] [exponent n] [metallic n] }
object { }
//! error: `object` needs an object
//!  --> missing.pov:6:1
//!   |
//! 6 | object { }
//!   | ^^^^^^
//! help: object { object [modifiers] }
sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1] [1] } } }
//! error: an entry of `color_map` needs a colour
//!  --> missing.pov:7:58
//!   |
//! 7 | sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1] [1] } } }
//!   |                                                          ^^^
//! help: color_map { [0 rgb <r, g, b>] [1 rgb <r, g, b>] }
global_settings { light_sampler { } }
//! error: `light_sampler` needs the name of a strategy
//!  --> missing.pov:8:19
//!   |
//! 8 | global_settings { light_sampler { } }
//!   |                   ^^^^^^^^^^^^^
//! help: light_sampler { light_octree [threshold n] ... }, or one of: every_light, constant_alpha, linear_alpha, light_bvh
