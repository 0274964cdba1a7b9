// SPDX-License-Identifier: CC0-1.0
// A ballroom under five chandeliers: 240 candles, whose light the vault, the columns and the marble
// floor pass on to each other.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 integrator { path_traced bounces 4 } }

camera {
    location <0.9, 1.5, -11>
    right 16/9*x
    up y
    angle 66
    look_at <0, 4.1, 4>
    film {
        exposure 0.6
        response agx
        white_balance 5800
        vignette 0.25
        glare { veil 0.1 halo 0.003 star 0.02 blades 8 angle 10 length 0.35 }
    }
}

#declare Matt = finish { ambient 0 diffuse 0.9 }
#declare Plaster = texture { pigment { rgb <0.8, 0.73, 0.62> } finish { Matt } }
#declare Gold = texture {
    pigment { rgb <0.85, 0.55, 0.2> }
    finish { ambient 0 microfacet { roughness 0.35 metallic 1 } }
}
#declare Glass = texture {
    pigment { rgb <0.9, 0.92, 0.95> }
    finish { ambient 0 diffuse 0.35 reflection 0.4 specular 0.8 roughness 0.005 }
}

// A chandelier: two hoops of candles, garlands of glass between and below them
#declare Candle = union {
    cylinder { 0, 0.16*y, 0.022 pigment { rgb <0.8, 0.76, 0.66> } finish { Matt } }
    cone { 0, 0.06, -0.04*y, 0.02 texture { Gold } }
    sphere {
        0, 0.035
        scale <1, 1.7, 1>
        translate 0.22*y
        pigment { rgb <1, 0.6, 0.26> }
        finish { ambient 0 diffuse 0 emission 80 }
    }
}
#declare Bead = sphere { 0, 0.03 texture { Glass } }
#macro Hoop(Candles, Radius, Top)
    torus { Radius, 0.025 texture { Gold } }
    object { Light_Ring(object { Candle translate 0.06*y }, Candles, Radius) }
    #for (I, 0, Candles/2 - 1)
        #local Hooks = array[2] {
            vrotate(<Radius, 0, 0>, 720*I/Candles*y), vrotate(<0.08, 0, 0>, 720*I/Candles*y) + Top*y
        };
        object { Light_String(Bead, 18, Hooks, 0.12) }
        #local Hooks = array[2] {
            vrotate(<Radius, 0, 0>, 720*I/Candles*y), vrotate(<Radius, 0, 0>, 720*(I + 1)/Candles*y)
        };
        object { Light_String(Bead, 10, Hooks, 0.3) }
    #end
#end
#declare Chandelier = union {
    union { Hoop(28, 0.95, 0.75) }
    union { Hoop(20, 0.6, 0.5) translate 0.45*y }
    #for (I, 0, 4)
        object { Light_Ring(Bead, 28 - 5*I, 0.8 - 0.17*I) translate -(0.1 + 0.1*I)*y }
    #end
    cylinder { -0.3*y, 4*y, 0.02 }
    sphere { 0.45*y, 0.1 }
    sphere { 0.8*y, 0.09 }
    sphere { -0.52*y, 0.08 texture { Glass } }
    texture { Gold }
}
#for (I, 0, 4)
    object { Chandelier scale 1.25 translate <0, 5.2, -3.5 + 6.4*I> }
#end

// The hall: a barrel vault with gilded ribs over two rows of columns
#declare Far = 28;
difference {
    box { <-5.6, 6, -14>, <5.6, 13, Far> }
    cylinder { <0, 6.4, -15>, <0, 6.4, Far + 1>, 4.6 }
    texture { Plaster }
}
#for (I, 0, 10)
    difference {
        cylinder { -0.22*z, 0.22*z, 4.65 }
        cylinder { -0.3*z, 0.3*z, 4.45 }
        plane { y, 0 }
        translate <0, 6.4, -10 + 4*I>
        texture { Plaster }
    }
    #for (Side, -1, 1, 2)
        union {
            cylinder { 0.5*y, 5.6*y, 0.36 }
            torus { 0.36, 0.09 translate 0.55*y }
            torus { 0.38, 0.1 translate 5.55*y texture { Gold } }
            box { <-0.5, 0, -0.5>, <0.5, 0.5, 0.5> }
            box { <-0.55, 5.6, -0.55>, <0.55, 5.85, 0.55> texture { Gold } }
            texture { Plaster }
            translate <3.9*Side, 0, -10 + 4*I>
        }
    #end
#end
#for (Side, -1, 1, 2)
    box { <3.4*Side, 5.85, -14>, <5.6*Side, 6.4, Far> texture { Plaster } }
    box { <3.36*Side, 6.05, -14>, <3.5*Side, 6.2, Far> texture { Gold } }
    // Walls with tall windows on the night
    difference {
        box { <5.6*Side, 0, -14>, <6*Side, 7, Far> }
        #for (I, 0, 9)
            union {
                box { <-1, 0.9, -1>, <1, 3.9, 1> }
                cylinder { <-1, 3.9, 0>, <1, 3.9, 0>, 1 }
                translate <5.8*Side, 0, -8 + 4*I>
            }
        #end
        pigment { rgb <0.1, 0.24, 0.22> }
        finish { Matt }
    }
#end
box { <-6, 0, Far>, <6, 12, Far + 0.5> texture { Plaster } }
box { <-6, 0, -14.5>, <6, 12, -14> texture { Plaster } }
background { rgb <0.003, 0.0055, 0.013> }

// A couple dances alone
union {
    sphere { 1.5*y, 0.11 }
    cone { 0, 0.42, 1.02*y, 0.12 pigment { rgb <0.75, 0.03, 0.04> } }
    cone { 0.98*y, 0.12, 1.36*y, 0.15 pigment { rgb <0.75, 0.03, 0.04> } }
    cylinder { 1.34*y, <0.4, 1.3, 0>, 0.04 }
    cylinder { <0.4, 1.3, 0>, <0.45, 1.42, 0.35>, 0.04 }
    sphere { <0, 1.68, 0.32>, 0.115 }
    cylinder { <0, 1.45, 0.33>, <0, 1.6, 0.32>, 0.05 }
    cylinder { 1.34*y, 1.42*y, 0.045 }
    cone { <0, 0.85, 0.34>, 0.14, <0, 1.5, 0.34>, 0.19 pigment { rgb 0.02 } }
    cylinder { <-0.08, 0, 0.36>, <-0.08, 0.9, 0.34>, 0.08 pigment { rgb 0.02 } }
    cylinder { <0.08, 0, 0.4>, <0.08, 0.9, 0.34>, 0.08 pigment { rgb 0.02 } }
    pigment { rgb <0.5, 0.3, 0.2> }
    finish { Matt }
    rotate -35*y
    translate <0.3, 0, -2.2>
}

// The floor, of polished marble
box {
    <-6, -1, -14>, <6, 0, Far>
    pigment { checker rgb <0.62, 0.56, 0.48>, rgb <0.07, 0.045, 0.04> scale 0.95 rotate 45*y }
    finish { ambient 0 diffuse 0.8 reflection { 0.08, 0.8 fresnel } }
    interior { ior 1.7 }
}
