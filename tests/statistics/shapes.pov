// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire of each shape, some under transformations that stretch and turn them, one with a pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> look_at <0, 0.5, 0> right x up y angle 60 }
#declare Glow = texture { pigment { rgb <1, 0.8, 0.6> } finish { ambient 0 diffuse 0 emission 2 } }
box { <-20, -1, -20>, <20, 0, 20> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 phong 0.3 } }
box { <-0.3, 0, -0.2>, <0.3, 1, 0.2> rotate 30*y translate <-3, 0, 0> texture { Glow } }
cylinder { <-2, 0.2, -1>, <-1, 1.5, -1>, 0.2 texture { Glow } }
cylinder { <-1, 0.1, 1.5>, <0, 0.9, 1.5>, 0.3 open texture { Glow } }
cone { <1, 0.01, 0>, 0.5, <1, 1, 0>, 0.1 scale <1, 1, 0.5> texture { Glow } }
disc { <2.5, 1.5, 0>, <-1, -1, 0.3>, 0.6, 0.2 texture { Glow } }
triangle { <-0.5, 0.3, -2>, <0.5, 0.5, -2>, <0, 1.2, -1.5> texture { Glow } }
smooth_triangle { <2, 0.1, 2>, y, <3, 0.1, 2>, y, <2.5, 1, 2.5>, x + y texture { Glow } }
sphere { 0, 0.4 scale <2, 0.5, 1> rotate 20*z translate <0, 2, 0.5> texture { Glow } }
box { 0, 1 scale <1, 1, 0.05> translate <-4, 0.2, 2> pigment { checker rgb 0, rgb 1 scale 0.25 } finish { ambient 0 diffuse 0 emission 3 } }
sphere { <3, 0.5, -2>, 0.5 pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }
