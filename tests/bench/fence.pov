// SPDX-License-Identifier: CC0-1.0
// Sharp shadows of a fence by two small lamps, with bounces: for the denoiser.
#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced } }
#default { finish { ambient 0 } }
camera { location <0, 1.5, -5> right x*image_width/image_height look_at <0, .8, 0> angle 60 }
plane { y, 0 pigment { rgb .7 } }
plane { -z, -2 pigment { rgb <.7, .6, .5> } }
#for (I, -8, 8) box { <.3*I - .04, 0, 0>, <.3*I + .04, 1, .05> pigment { rgb .5 } } #end
sphere { <-2, 2.5, -2>, .05 pigment { rgb 1 } finish { diffuse 0 emission 300 } }
sphere { <2, 1.5, -3>, .05 pigment { rgb <1, .6, .3> } finish { diffuse 0 emission 300 } }
