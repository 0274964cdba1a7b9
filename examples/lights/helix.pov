// SPDX-License-Identifier: CC0-1.0
// Light_Helix: two strands of lamps wind up a column, a third round the cone on its top.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <3.4, 2.6, -8.5>
    right 4/3*x
    up y
    angle 40
    look_at <0, 2.2, 0>
}

#macro Lamp(Colour)
    sphere { <0, 0, 0>, 0.06 pigment { Colour } finish { ambient 0 diffuse 0 emission 7 } }
#end

#declare Matt = texture { pigment { rgb <0.66, 0.63, 0.6> } finish { ambient 0 diffuse 1 } }
cylinder { <0, 0, 0>, <0, 3, 0>, 0.7 texture { Matt } }
cone { <0, 3, 0>, 0.9, <0, 4.4, 0>, 0 texture { Matt } }

object { Light_Helix(Lamp(rgb <1, 0.22, 0.03>), 110, 0.85, 2.9, 4) translate 0.05*y }
object { Light_Helix(Lamp(rgb <0.05, 0.14, 1>), 110, 0.85, 2.9, 4) rotate 180*y translate 0.05*y }
object { Light_Helix(Lamp(rgb <0.5, 0.36, 0.16>), 50, <1, 0.08>, 1.4, 5) translate 3.08*y }

plane { y, 0 pigment { rgb 0.4 } finish { ambient 0 diffuse 1 reflection 0.1 } }
#for (I, 0, 8)
    box {
        <-0.2, 0, -0.2>, <0.2, 0.4, 0.2>
        texture { Matt }
        rotate 25*y
        translate 2.3*x
        rotate 40*I*y
    }
#end
