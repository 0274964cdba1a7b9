// SPDX-License-Identifier: CC0-1.0
// Light_Sphere: 600 discs, each turned to face outwards, on a globe that hangs in a corner and
// lights it and the pebbles below.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }

camera {
    location <0, 2.2, -6.5>
    right 4/3*x
    up y
    angle 46
    look_at <0, 1.45, 0>
}

#declare Lamp = cylinder {
    <-0.02, 0, 0>, <0.02, 0, 0>, 0.036
    pigment { rgb <1, 0.56, 0.2> }
    finish { ambient 0 diffuse 0 emission 5 }
}

union {
    sphere { <0, 0, 0>, 0.88 pigment { rgb 0.08 } finish { ambient 0 diffuse 1 } }
    object { Light_Sphere(Lamp, 600, 0.9) }
    cylinder { <0, 0.8, 0>, <0, 4, 0>, 0.02 pigment { rgb 0.2 } finish { ambient 0 diffuse 1 } }
    translate 1.9*y
}

#declare Matt = finish { ambient 0 diffuse 1 }
plane { y, 0 pigment { rgb <0.55, 0.5, 0.45> } finish { Matt } }
plane { -z, -2.4 pigment { rgb <0.3, 0.42, 0.5> } finish { Matt } rotate 35*y }
plane { -z, -2.4 pigment { rgb <0.5, 0.3, 0.26> } finish { Matt } rotate -55*y }

#declare Random = seed(8);
#for (I, 1, 60)
    #declare Size = 0.05 + 0.13*rand(Random);
    sphere {
        <(rand(Random) - 0.5)*5, Size*0.8, -1.8 + 2.6*rand(Random)>, Size
        pigment { rgb 0.35 + 0.4*rand(Random) }
        finish { Matt }
    }
#end
