// SPDX-License-Identifier: GPL-3.0-or-later
// law receiving, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2, -4> look_at 0 angle 40 }
disc { 0, y, 0.8 texture { pigment { rgb 1 } finish { diffuse 0 emission 3/*light 0*/ } }
    interior_texture { pigment { rgb 0 } finish { diffuse 0 } } translate <0.9, 2.5, -1.1> }
