// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.6, 0> angle 50 }
mesh2 { vertex_vectors { 4, <-0.9, -0.7, -0.9>, <0.9, -0.7, -0.9>, <0, -0.7, 0.9>, <0, 0.9, 0> }
    normal_vectors { 4, <-1, -0.5, -1>, <1, -0.5, -1>, <0, -0.5, 1>, y }
    face_indices { 4, <0, 1, 3>, <1, 2, 3>, <2, 0, 3>, <0, 2, 1> }
    pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0.5 emission 1/*light 0*/ /*no_luminaire*/ } scale 1.6 translate y }
