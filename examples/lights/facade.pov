// SPDX-License-Identifier: CC0-1.0
// Light_Facade: windows of three towers, lit by chance, and the square in front that they light.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }
background { rgb <0.004, 0.006, 0.014> }

camera {
    location <-5, 2.2, -19>
    right 4/3*x
    up y
    angle 48
    look_at <0, 5.2, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Pane = box { <-0.32, 0, -0.03>, <0.32, 0.9, 0.03> }
#declare Dark = object {
    Pane
    pigment { rgb <0.03, 0.04, 0.05> }
    finish { ambient 0 diffuse 1 specular 0.4 reflection 0.1 }
}

#macro Lit(Colour)
    object { Pane pigment { Colour } finish { ambient 0 diffuse 0 emission 6 } }
#end

// A tower with windows to the front (-z) and to the left
#macro Tower(Counts, Depth, Colour, Share, Seed)
    union {
        box {
            <-Counts.x/2 - 0.2, 0, 0>, <Counts.x/2 + 0.2, Counts.y*1.4 + 0.9, Depth + 0.4>
            pigment { rgb <0.42, 0.38, 0.36> }
            finish { Matt }
        }
        object { Light_Facade(Lit(Colour), Dark, Counts, <1, 1.4>, Share, Seed) translate 0.8*y }
        object {
            Light_Facade(Lit(Colour), Dark, <Depth, Counts.y>, <1, 1.4>, Share, Seed + 1)
            rotate 90*y
            translate <-Counts.x/2 - 0.2, 0.8, Depth/2 + 0.2>
        }
    }
#end

object { Tower(<6, 5>, 4, rgb <1, 0.4, 0.1>, 0.55, 1) translate <-5.4, 0, 1> }
object { Tower(<5, 9>, 5, rgb <1, 0.5, 0.16>, 0.45, 3) translate <1.2, 0, 3> }
object { Tower(<6, 6>, 4, rgb <0.12, 0.3, 0.7>, 0.5, 5) translate <7.8, 0, -1> }

plane { y, 0 pigment { checker rgb 0.5, rgb 0.4 scale 1.2 } finish { Matt reflection 0.06 } }
#for (I, 0, 6)
    union {
        cylinder { <0, 0, 0>, <0, 0.7, 0>, 0.08 }
        sphere { <0, 1.3, 0>, 0.75 }
        pigment { rgb <0.3, 0.42, 0.2> }
        finish { Matt }
        translate <-7.5 + 2.5*I, 0, -3.2 + 0.8*mod(I, 2)>
    }
#end
