// SPDX-License-Identifier: CC0-1.0
// Light_String and Light_Wire: strings of bulbs hang in zigzag between two rows of posts over a
// terrace.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }

camera {
    location <0.9, 1.75, -6>
    right 4/3*x
    up y
    angle 60
    look_at <0, 1.7, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Bulb = union {
    sphere {
        <0, -0.09, 0>, 0.05
        pigment { rgb <1, 0.62, 0.26> }
        finish { ambient 0 diffuse 0 emission 26 }
    }
    cylinder { <0, -0.05, 0>, <0, 0, 0>, 0.02 pigment { rgb 0.05 } finish { Matt } }
}

#declare Posts = array[8];
#for (I, 0, 7)
    #declare Posts[I] = <(mod(I, 2) ? 2.6 : -2.6), 3, -3.5 + 1.5*I>;
    cylinder {
        Posts[I]*<1, 0, 1>, Posts[I] + 0.1*y, 0.05
        pigment { rgb <0.3, 0.2, 0.12> }
        finish { Matt }
    }
#end

object { Light_String(Bulb, 120, Posts, 0.12) }
#declare Track = Light_String_Track(Posts, 0.12);
object { Light_Wire(Track, 0.008) pigment { rgb 0.03 } finish { Matt } }

plane {
    y, 0
    pigment { checker rgb <0.5, 0.4, 0.32>, rgb <0.4, 0.3, 0.23> scale 0.7 }
    finish { Matt }
}
box { <-4.5, 0, 8>, <4.5, 4.2, 8.2> pigment { rgb <0.55, 0.38, 0.3> } finish { Matt } }

// Tables for the guests
#for (I, 0, 5)
    union {
        cylinder { <0, 0.7, 0>, <0, 0.75, 0>, 0.5 }
        cylinder { <0, 0, 0>, <0, 0.7, 0>, 0.06 }
        cylinder { <0.75, 0, 0>, <0.75, 0.42, 0>, 0.18 }
        cylinder { <-0.75, 0, 0>, <-0.75, 0.42, 0>, 0.18 }
        pigment { rgb 0.6 }
        finish { Matt }
        rotate 40*I*y
        translate <1.2*(mod(I, 2) ? 1 : -1), 0, -2.2 + 1.6*I>
    }
#end
