// SPDX-License-Identifier: GPL-3.0-or-later
// An array has no such element, a mesh no such vertex
#version 3.7;
#declare Sizes = array[3] { 1, 2, 3 }
sphere { 0, Sizes[3] }
//! error: the index must be from 0 to 2, but it is 3
//!  --> index_out_of_range.pov:5:19
//!   |
//! 5 | sphere { 0, Sizes[3] }
//!   |                   ^
mesh2 {
//! error: entry 0 of `face_indices` names vertex 3, but there are 3 vertices, counted from 0
//!  --> index_out_of_range.pov:6:1
//!   |
//! 6 | mesh2 {
//!   | ^^^^^
//! help: mesh2 { [vertex_vectors { count, ... }] [normal_vectors { count, ... }] [uv_vectors { count, ... }] ... }
    vertex_vectors { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    face_indices { 1, <0, 1, 3> }
}
mesh2 {
    vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
//! error: `vertex_vectors` has 3 entries, but its count is 4
//!   --> index_out_of_range.pov:11:5
//!    |
//! 11 |     vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
//!    |     ^^^^^^^^^^^^^^   - the count is 4
    face_indices { 1, <0, 1, 0.5> }
//! warning[no-effect]: an entry of `face_indices` is three whole numbers; what is behind their points does not count
//!   --> index_out_of_range.pov:12:23
//!    |
//! 12 |     face_indices { 1, <0, 1, 0.5> }
//!    |                       ^^^^^^^^^^^
}
