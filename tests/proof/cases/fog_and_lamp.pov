// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2, -4> look_at 0 angle 40 }
fog { rgb 0 distance 4 }
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <0, 4, 0>, 1.5 pigment { rgb 1 } finish { emission 4/*light 0*/ diffuse 0 /*no_luminaire*/ } }
