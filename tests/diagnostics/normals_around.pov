// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a picture that lies around a ball
#version 3.7;
sphere { 0, 1 normal { bump_map { function 8, 8 { x } tangent_space map_type 1 } } }
//! error: a picture in `tangent_space` lies flat, or with `uv_mapping` on the surface: it takes no `map_type`
//!  --> normals_around.pov:4:24
//!   |
//! 4 | sphere { 0, 1 normal { bump_map { function 8, 8 { x } tangent_space map_type 1 } } }
//!   |                        ^^^^^^^^
//! help: normal { uv_mapping bump_map { "normals.png" tangent_space } }
