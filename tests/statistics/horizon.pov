// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere beside a luminaire that fills much of its sky: the centre of the luminaire is below the horizon of points that it
// lights (the paper, Figure 4). Small ones beside it are not forgotten for it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -9> right 2.2*x up 2.2*y direction z }
sphere { 0, 1 pigment { rgb 0.9 } finish { ambient 0 diffuse 1 } }
sphere { <6, 0, 0>, 4.6 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
sphere { <-1.5, 1.5, -1>, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 20 } }
sphere { <0, -1.5, -1>, 0.05 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 20 } }
