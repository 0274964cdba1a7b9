// SPDX-License-Identifier: CC0-1.0
// Fine texture in colour, in bumps and in light: for the denoiser.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 } }
camera { location <0, 1.5, -5> right x*image_width/image_height look_at <0, .8, 0> angle 60 }
plane { y, 0 pigment { checker rgb .7, rgb <.3, .1, .05> scale .05 } }
plane { -z, -2 pigment { granite color_map { [0 rgb .1] [1 rgb .9] } scale .5 } normal { bumps 1 scale .05 } }
sphere { <-.9, .6, 0>, .6 pigment { rgb .7 } normal { wrinkles 1 scale .1 } }
sphere { <.7, .5, -.5>, .5 pigment { rgb .05 } finish { reflection .6 } }
#for (I, 0, 9)
  box { <-2 + .4*I, 3, -1>, <-1.8 + .4*I, 3.1, 1> pigment { rgb 1 } finish { diffuse 0 emission 4 } }
#end
