// SPDX-License-Identifier: GPL-3.0-or-later
// law point, seed 1
// open
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 radiosity { recursion_limit 1 } }
camera { location <0, 2.2, -5> look_at <0, 0.7, 0> angle 45 }
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <0, 0.7, 0>, 0.7 pigment { rgb 0.8 } finish { diffuse 0.8 } }
