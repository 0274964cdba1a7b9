// SPDX-License-Identifier: GPL-3.0-or-later
// law receiving, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2, -4> look_at 0 angle 40 }
sphere { 0, 20 hollow pigment { rgb 1 } finish { diffuse 0 emission 1/*light 0*/ } }
box { <-9, 1.2, -9>, <9, 1.22, 9> pigment { rgb 1 transmit 1 } finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } }
plane { y, -1 pigment { rgb 0 } finish { diffuse 0 } }
