// SPDX-License-Identifier: GPL-3.0-or-later
// Everything stands inside a large glowing sphere, with small lamps of great and of no brightness in one channel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.5, 0> right x up y angle 50 }
sphere { 0, 30 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.2 } }
box { <-3, -0.5, -3>, <3, 0, 3> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
sphere { <0, 1, 0>, 0.8 pigment { rgb <0.5, 0.9, 0.5> } finish { ambient 0 diffuse 1 } }
#for (I, 0, 4)
    sphere { <2, 0.5, 0>, 0.1 rotate 72*I*y pigment { rgb <0, 0, 1> } finish { ambient 0 diffuse 0 emission 30 } }
#end
