// SPDX-License-Identifier: CC0-1.0
// After Figure 5 of Shirley and Wang, "Luminaire Sampling in Distribution Ray Tracing": a room with
// 108 luminaires. Here they are 72 bulbs under the ceiling and 36 in three chandeliers over the
// table.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

camera {
    location <-4.6, 2.1, -5.2>
    right 4/3*x
    up y
    angle 70
    look_at <0.6, 1.2, 1>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Wood = texture {
    pigment { rgb <0.45, 0.24, 0.11> }
    finish { ambient 0 diffuse 0.9 phong 0.3 phong_size 40 }
}
#declare Steel = texture {
    pigment { rgb 0.3 }
    finish { ambient 0 diffuse 0.6 specular 0.5 roughness 0.02 reflection 0.3 }
}

// The room: 12 wide, 3.6 high, 12 deep
box {
    <-6, -0.1, -6>, <6, 0, 6>
    pigment { checker rgb <0.62, 0.58, 0.5>, rgb <0.2, 0.14, 0.1> scale 0.75 }
    finish { Matt reflection 0.05 }
}
box { <-6, 3.6, -6>, <6, 3.7, 6> pigment { rgb 0.75 } finish { Matt } }
box { <-6, 0, 6>, <6, 3.6, 6.1> pigment { rgb <0.62, 0.55, 0.42> } finish { Matt } }
box { <6, 0, -6>, <6.1, 3.6, 6> pigment { rgb <0.34, 0.45, 0.5> } finish { Matt } }
box { <-6.1, 0, -6>, <-6, 3.6, 6> pigment { rgb <0.55, 0.28, 0.2> } finish { Matt } }
box { <-6, 0, -6.1>, <6, 3.6, -6> pigment { rgb 0.6 } finish { Matt } }

#declare Chair = union {
    box { <-0.25, 0.45, -0.25>, <0.25, 0.5, 0.25> }
    box { <-0.25, 0.5, 0.2>, <0.25, 1.05, 0.25> }
    #for (I, 0, 3)
        cylinder { <0, 0, 0>, <0, 0.45, 0>, 0.025 translate <0.21, 0, 0.21> rotate 90*I*y }
    #end
    texture { Wood }
}

// A long table with six chairs, and things to see by its light
union {
    box { <-2.4, 0.75, -0.6>, <2.4, 0.82, 0.6> }
    cylinder { <-1.8, 0, 0>, <-1.8, 0.75, 0>, 0.12 }
    cylinder { <1.8, 0, 0>, <1.8, 0.75, 0>, 0.12 }
    texture { Wood }
}
#for (I, -1, 1)
    object { Chair translate <1.5*I, 0, 0.8> }
    object { Chair rotate 180*y translate <1.5*I, 0, -0.8> }
#end
sphere { <-0.7, 1.02, 0>, 0.2 texture { Steel } }
cone {
    <0.2, 0.82, 0.1>, 0.14, <0.2, 1.22, 0.1>, 0.06
    pigment { rgb <0.15, 0.35, 0.6> }
    finish { Matt }
}
sphere { <1, 0.97, -0.15>, 0.15 pigment { rgb <0.75, 0.12, 0.08> } finish { Matt phong 0.6 } }
#for (I, 0, 3)
    cylinder {
        <5.2, 0, -4 + 2.6*I>, <5.2, 3.6, -4 + 2.6*I>, 0.22
        pigment { rgb 0.7 }
        finish { Matt }
    }
#end

// 12 by 6 bulbs under the ceiling, and three rings of 12
#declare Bulb = sphere {
    <0, 0, 0>, 0.05
    pigment { rgb <1, 0.86, 0.66> }
    finish { ambient 0 diffuse 0 emission 32 }
}
object { Light_Grid(Bulb, <12, 1, 6>, <0.95, 0, 1.9>) translate 3.5*y }
#for (I, -1, 1)
    object { Light_Ring(Bulb, 12, 0.45) translate <1.5*I, 2.1, 0> }
    cylinder { <1.5*I, 2.12, 0>, <1.5*I, 2.16, 0>, 0.42 texture { Steel } }
    cylinder { <1.5*I, 2.15, 0>, <1.5*I, 3.6, 0>, 0.015 texture { Steel } }
#end
