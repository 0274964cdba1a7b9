// SPDX-License-Identifier: CC0-1.0
// A lantern festival: 420 paper lanterns rise over a lake, 110 candles float on it. Both are
// scattered so that no two touch.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.006, 0.011, 0.03> }

camera {
    location <0, 1.7, -11>
    right 16/9*x
    up y
    angle 58
    look_at <0, 3, 4>
}

#declare Matt = finish { ambient 0 diffuse 1 }

// A lantern: a shell of glowing paper, darker at the rim
#declare Lantern = union {
    cone {
        <0, 0, 0>, 0.13, <0, 0.4, 0>, 0.19
        open
        pigment { rgb <1, 0.3, 0.05> }
        finish { ambient 0 diffuse 0 emission 1.9 }
    }
    sphere {
        <0, 0.08, 0>, 0.06
        pigment { rgb <1, 0.6, 0.2> }
        finish { ambient 0 diffuse 0 emission 12 }
    }
    cylinder {
        <0, -0.02, 0>, <0, 0.02, 0>, 0.135
        open
        pigment { rgb <0.3, 0.12, 0.05> }
        finish { Matt }
    }
}
#declare Candle = union {
    sphere {
        <0, 0.11, 0>, 0.05
        pigment { rgb <1, 0.55, 0.18> }
        finish { ambient 0 diffuse 0 emission 14 }
    }
    #for (I, 0, 5)
        disc {
            <0.13, 0.05, 0>, <-0.5, 1, 0>, 0.09
            pigment { rgb <0.75, 0.42, 0.5> }
            finish { Matt }
            rotate 60*I*y
        }
    #end
}

object { Light_Scatter(Lantern, 300, <-16, 2.2, 2>, <16, 13, 30>, 1.3, 3) }
object { Light_Scatter(Lantern, 60, <-7, 2.4, -4>, <7, 6, 3>, 1.1, 9) }
object { Light_Scatter(object { Lantern scale 0.8 }, 60, <-12, 1, 8>, <12, 3, 26>, 1, 14) }
object { Light_Scatter(Candle, 110, <-8, 0, -8>, <8, 0, 10>, 0.75, 21) }

// The lake, hills beyond it, and two boats
plane { y, 0 pigment { rgb <0.03, 0.05, 0.07> } finish { ambient 0 diffuse 1 reflection 0.6 } }
#declare Random = seed(5);
#for (I, 0, 12)
    sphere {
        <-60 + 10*I, -14 + 3*rand(Random), 52 + 8*rand(Random)>, 18 + 3*rand(Random)
        pigment { rgb <0.12, 0.16, 0.14> }
        finish { Matt }
    }
#end
#declare Boat = union {
    #for (I, -8, 8)
        #declare Width = 0.42*sqrt(1 - I*I/81);
        box { <-Width, 0.02 + 0.004*I*I, 0.16*I - 0.08>, <Width, 0.24 + 0.004*I*I, 0.16*I + 0.08> }
    #end
    cylinder { <0, 0.3, 0.9>, <0, 1.15, 0.9>, 0.03 }
    cone { <0, 0.28, -0.2>, 0.24, <0, 0.85, -0.2>, 0.1 }
    sphere { <0, 1, -0.2>, 0.14 }
    cone { <0, 1.02, -0.2>, 0.32, <0, 1.2, -0.2>, 0 }
    pigment { rgb <0.5, 0.33, 0.2> }
    finish { Matt }
}
union {
    object { Boat } object { Lantern translate <0, 1.15, 0.9> }
    rotate 62*y
    translate <-3.1, 0, -2.6>
}
union {
    object { Boat } object { Lantern translate <0, 1.15, 0.9> }
    rotate -48*y
    translate <3.6, 0, 0.8>
}
