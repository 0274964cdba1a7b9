// SPDX-License-Identifier: CC0-1.0
// A chandelier: 56 candle bulbs on three gilded tiers, hung with almost 800 pieces of glass. The
// garlands are Light_String macros too: an array of lamps may as well array drops of glass.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }

camera {
    location <0, 0.4, -6.4>
    right x
    up y
    angle 44
    look_at <0, 1.85, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Gold = texture {
    pigment { rgb <0.6, 0.4, 0.13> }
    finish { ambient 0 diffuse 0.6 specular 0.7 roughness 0.03 reflection 0.3 }
}
#declare Crystal = texture {
    pigment { rgbf <0.97, 0.98, 1, 0.92> }
    finish { ambient 0 diffuse 0.05 specular 0.9 roughness 0.004 reflection 0.12 }
}

#declare Bead = sphere { <0, 0, 0>, 0.032 texture { Crystal } interior { ior 1.5 } }
#declare Drop = union {
    cone { <0, 0, 0>, 0.006, <0, -0.14, 0>, 0.045 }
    cone { <0, -0.14, 0>, 0.045, <0, -0.2, 0>, 0 }
    texture { Crystal }
    interior { ior 1.5 }
}
#declare Candle = union {
    sphere {
        <0, 0.26, 0>, 0.04
        pigment { rgb <1, 0.66, 0.3> }
        finish { ambient 0 diffuse 0 emission 70 }
    }
    cylinder { <0, 0, 0>, <0, 0.22, 0>, 0.028 pigment { rgb <0.8, 0.76, 0.66> } finish { Matt } }
    cone { <0, 0, 0>, 0.09, <0, -0.05, 0>, 0.03 texture { Gold } }
}

// A tier: a hoop of small gilded balls, candles on it, drops under it, garlands between candles
#macro Tier(Candles, Radius, Height)
    union {
        object { Light_Ring(sphere { <0, 0, 0>, 0.035 texture { Gold } }, Candles*12, Radius) }
        object { Light_Ring(object { Candle translate 0.07*y }, Candles, Radius) }
        object { Light_Ring(object { Drop translate -0.04*y }, Candles*3, Radius) }
        #local Hooks = array[Candles + 1];
        #for (I, 0, Candles)
            #local Hooks[I] = vrotate(<Radius + 0.07, 0, 0>, 360*mod(I, Candles)/Candles*y);
        #end
        object { Light_String(Bead, Candles*9, Hooks, 0.3) }
        #for (I, 0, 7)
            cylinder { <Radius, 0, 0>, <0.08, 0.5, 0>, 0.02 texture { Gold } rotate 45*I*y }
        #end
        translate Height*y
    }
#end

union {
    object { Tier(28, 1.5, 1.5) }
    object { Tier(18, 1, 2.05) }
    object { Tier(10, 0.55, 2.6) }
    cylinder { <0, 0.9, 0>, <0, 4, 0>, 0.05 texture { Gold } }
    #for (I, 0, 5)
        sphere { <0, 1 + 0.42*I, 0>, 0.1 + 0.04*mod(I, 2) texture { Gold } }
    #end
    #for (I, 0, 4)
        object {
            Light_Ring(object { Drop scale 1.4 }, 36 - 7*I, 1.2 - 0.24*I)
            translate (1.32 - 0.14*I)*y
        }
    #end
    sphere { <0, 0.62, 0>, 0.13 texture { Crystal } interior { ior 1.5 } }
}

// The hall
plane { -y, -4 pigment { rgb <0.6, 0.55, 0.48> } finish { Matt } }
plane { -z, -4 pigment { rgb <0.34, 0.1, 0.1> } finish { Matt } }
plane { y, -3 pigment { rgb 0.3 } finish { Matt } }
#for (I, -2, 2)
    cylinder {
        <2.1*I, -3, 3.8>, <2.1*I, 4, 3.8>, 0.3
        pigment { rgb <0.66, 0.6, 0.5> }
        finish { Matt }
    }
    sphere { <2.1*I, 3.7, 3.8>, 0.46 texture { Gold } }
#end
