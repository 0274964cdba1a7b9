// SPDX-License-Identifier: CC0-1.0
// Light_Line: straight rows of lamps light a flight of steps from the edge of every tread.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }

camera {
    location <-1.5, 2.1, -6.6>
    right 4/3*x
    up y
    angle 44
    look_at <0.1, 1.45, 0.6>
}

#declare Stone = texture { pigment { rgb <0.62, 0.58, 0.52> } finish { ambient 0 diffuse 1 } }
#declare Lamp = sphere {
    <0, 0, 0>, 0.035
    pigment { rgb <1, 0.7, 0.38> }
    finish { ambient 0 diffuse 0 emission 11 }
}

// Seven steps; the lamps sit under the nose of each
#for (I, 0, 6)
    box { <-2, 0, 0.6*I>, <2, 0.32*(I + 1), 6> texture { Stone } }
    box {
        <-2, 0.32*(I + 1), 0.6*I - 0.12>, <2, 0.32*(I + 1) + 0.04, 0.6*I + 0.6>
        texture { Stone }
    }
    object {
        Light_Line(Lamp, 40, -1.92*x, 1.92*x)
        translate <0, 0.32*(I + 1) - 0.05, 0.6*I - 0.06>
    }
#end

plane { y, 0 texture { Stone } }
box {
    <-2.7, 0, 0.3>, <-2.1, 3.2, 6>
    pigment { rgb <0.5, 0.58, 0.7> }
    finish { ambient 0 diffuse 1 }
}
box { <2.1, 0, 0.3>, <2.7, 3.2, 6> pigment { rgb <0.5, 0.58, 0.7> } finish { ambient 0 diffuse 1 } }
sphere { <-2.4, 3.5, 0.8>, 0.3 texture { Stone } }
sphere { <2.4, 3.5, 0.8>, 0.3 texture { Stone } }

// A portal at the top
box { <-2.1, 2.2, 4.6>, <-1.5, 4.4, 5> texture { Stone } }
box { <1.5, 2.2, 4.6>, <2.1, 4.4, 5> texture { Stone } }
box { <-2.1, 4, 4.5>, <2.1, 4.5, 5.1> texture { Stone } }
object { Light_Line(Lamp, 60, -1.4*x, 1.4*x) translate <0, 3.95, 4.55> }
