// SPDX-License-Identifier: CC0-1.0
// Small bright lamps before a black sky, thin posts, and a checkered floor: for the denoiser.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 } }
camera { location <0, 1.5, -5> right x*image_width/image_height look_at <0, .8, 0> angle 60 }
plane { y, 0 pigment { checker rgb .7, rgb .2 scale .3 } }
#declare S = seed(3);
#for (I, 1, 12)
  #declare P = <rand(S)*6 - 3, 0, rand(S)*5 - 1>;
  cylinder { P, P + 1.8*y, .02 pigment { rgb .5 } }
#end
#for (I, 1, 200)
  sphere { <rand(S)*6 - 3, .1 + rand(S)*2, rand(S)*5 - 1>, .02
    pigment { rgb <1, .8, .6> } finish { diffuse 0 emission 90 } }
#end
