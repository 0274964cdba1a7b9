// SPDX-License-Identifier: GPL-3.0-or-later
// faces of mesh2 by numbers with fractions
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 }
mesh2 {
  vertex_vectors { 3, 0, x, y }
  face_indices { 2, <0, 1.5, 2>, <0, 1, 2.5> }
}
