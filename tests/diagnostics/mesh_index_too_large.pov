// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a vertex that is not there
#version 3.7;
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }
//! error: entry 0 of `face_indices` names vertex 3, but there are 3 vertices, counted from 0
//!  --> mesh_index_too_large.pov:4:1
//!   |
//! 4 | mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }
//!   | ^^^^^
//! help: mesh2 { [vertex_vectors { count, ... }] [normal_vectors { count, ... }] [uv_vectors { count, ... }] ... }
