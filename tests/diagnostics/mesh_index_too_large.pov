// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a vertex that is not there
#version 3.7;
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }
