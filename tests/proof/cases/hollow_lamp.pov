// SPDX-License-Identifier: GPL-3.0-or-later
// law reflected, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 0, -2.8> look_at 0 angle 90 }
difference { box { -5, 5 } box { -4, 4 } pigment { rgb 1 } finish { diffuse 0.6 emission 0.4/*light 0*/ } }
