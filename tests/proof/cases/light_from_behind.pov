// SPDX-License-Identifier: GPL-3.0-or-later
// law strategies, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 1, 0> angle 50 }
plane { y, 0 pigment { rgb 0.7 } }
polygon { 5, <-1.5, 0>, <1.5, 0>, <1.5, 2.5>, <-1.5, 2.5>, <-1.5, 0> pigment { rgb 0.9 } finish { diffuse 0.4, 0.4 } translate z }
sphere { 0, 20 hollow pigment { rgb 1 } finish { diffuse 0 emission 1/*light 0*/ } }
