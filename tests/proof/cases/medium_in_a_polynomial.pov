// SPDX-License-Identifier: GPL-3.0-or-later
// law receiving, seed 1436852323
// open
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -5> look_at <0, 0.7, 0> angle 45 }
polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -0.3 texture { pigment { rgb 1 transmit 1 } finish { diffuse 0 } } hollow interior { media { emission 0.5/*light 0*/*<1, 0.8, 0.4> absorption 0.5 } luminaire/*luminaire*/ } translate <-0.2, 0.9, 0> }
