// SPDX-License-Identifier: GPL-3.0-or-later
// An array has no such element, a mesh no such vertex
#version 3.7;
#declare Sizes = array[3] { 1, 2, 3 }
sphere { 0, Sizes[3] }
mesh2 {
    vertex_vectors { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    face_indices { 1, <0, 1, 3> }
}
mesh2 {
    vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
    face_indices { 1, <0, 1, 0.5> }
}
