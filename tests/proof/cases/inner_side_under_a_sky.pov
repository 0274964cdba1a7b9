// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 1436852323
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -5> look_at <0, 0.7, 0> angle 45 }
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sky_sphere { pigment { rgb 1 } emission 0.5 }
quadric { <1, 1.5, 1>, <0.2, 0, 0>, <0, 0.1, 0>, -0.5 texture { pigment { rgb 1 transmit 1 } finish { diffuse 0 } } interior_texture { pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0.3 emission 2/*light 0*/ /*no_luminaire*/ } } hollow translate <-0.2, 0.9, 0> }
