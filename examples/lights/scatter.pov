// SPDX-License-Identifier: CC0-1.0
// Light_Box: 700 glow-worms over a meadow, no two closer than 0.14, and the stalks they light.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }
background { rgb <0.002, 0.003, 0.008> }

camera {
    location <0, 1.5, -6.4>
    right 4/3*x
    up y
    angle 50
    look_at <0, 0.55, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Worm = sphere {
    <0, 0, 0>, 0.026
    pigment { rgb <0.62, 1, 0.16> }
    finish { ambient 0 diffuse 0 emission 10 }
}
#declare Stalk = cone {
    <0, 0, 0>, 0.022, <0, 0.7, 0>, 0
    pigment { rgb <0.25, 0.45, 0.12> }
    finish { Matt }
}

object { Light_Box(Worm, 700, <-4.5, 0.1, -4>, <4.5, 1.1, 5>, 0.14, 4) }

// The meadow is scattered too: any object will do.
#declare From = <-5, 0, -4.5>;
#declare To = <5, 0, 5>;
object { Light_Box(object { Stalk rotate 12*z }, 1500, From, To, 0.1, 11) }
object { Light_Box(object { Stalk scale <1, 1.3, 1> rotate -9*x }, 1200, From, To, 0.1, 12) }
object {
    Light_Box(sphere { <0, 0.1, 0>, 0.26 }, 14, <-4, 0, -2.5>, <4, 0, 4>, 1, 5)
    pigment { rgb <0.5, 0.48, 0.45> }
    finish { Matt }
}
plane { y, 0 pigment { rgb <0.16, 0.2, 0.1> } finish { Matt } }
