// SPDX-License-Identifier: GPL-3.0-or-later
// law receiving, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2, -4> look_at 0 angle 40 }
sphere { 0, 0.8 pigment { rgb 1 transmit 1 } finish { diffuse 0 } hollow
    interior { media { emission 1/*light 0*/ absorption 0.3 } luminaire/*luminaire*/ }
    clipped_by { plane { -y, 0 } } translate <0.9, 2.5, -1.1> }
