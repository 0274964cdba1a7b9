// SPDX-License-Identifier: GPL-3.0-or-later
// faces of mesh2 by numbers with fractions
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 }
mesh2 {
  vertex_vectors { 3, 0, x, y }
  face_indices { 2, <0, 1.5, 2>, <0, 1, 2.5> }
//! warning[no-effect]: an entry of `face_indices` is three whole numbers; what is behind their points does not count
//!  --> fraction_in_face.pov:8:21
//!   |
//! 8 |   face_indices { 2, <0, 1.5, 2>, <0, 1, 2.5> }
//!   |                     ^^^^^^^^^^^
}
