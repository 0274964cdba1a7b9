// SPDX-License-Identifier: GPL-3.0-or-later
// law strategies, seed 6
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.5, 0> angle 50 }
plane { y, 0 pigment { rgb 0.7 } }
sphere { <0, 1e9, 0>, 2e8 pigment { rgb 1 } finish { emission 10/*light 0*/ diffuse 0 } }
union { #for (I, 0, 40) sphere { <sin(I)*2, 0.5, cos(I)*2>, 0.02 pigment { rgb 1 } finish { emission 100/*light 1*/ diffuse 0 } } #end }
