// SPDX-License-Identifier: CC0-1.0
// A ballroom under five chandeliers: 240 candles, whose light the vault, the columns and the marble
// floor pass on to each other.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 integrator { path_traced bounces 4 } }

camera {
    location <0, 1, -12.6>
    right 16/9*x
    up y
    angle 64
    look_at <0, 2.9, 4>
    film {
        exposure 1.2
        response agx
        white_balance 4000
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
    object { Chandelier scale 1.25 translate <0, 5.2, -1.5 + 6.4*I> }
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
    #for (I, 0, 9)
        union {
            box { <-0.04, 0.9, -0.04>, <0.04, 4.9, 0.04> }
            #for (Bar, 0, 3) box { <-0.03, 1.7 + 0.8*Bar, -1>, <0.03, 1.75 + 0.8*Bar, 1> } #end
            box { <-0.25, 0.85, -1.15>, <0.25, 0.95, 1.15> }
            translate <5.75*Side, 0, -8 + 4*I>
            texture { Gold }
        }
    #end
#end
box { <-6, 0, Far>, <6, 12, Far + 0.5> texture { Plaster } }
box { <-6, 0, -14.5>, <6, 12, -14> texture { Plaster } }
background { rgb <0.007, 0.013, 0.032> }

// A couple dances alone
#declare Skin = texture { pigment { rgb <0.6, 0.36, 0.25> } finish { Matt } }
#declare Silk = texture {
    pigment { rgb <0.72, 0.02, 0.035> }
    finish { ambient 0 diffuse 0.8 specular 0.2 roughness 0.05 }
}
#declare Black = texture {
    pigment { rgb 0.018 }
    finish { ambient 0 diffuse 0.9 specular 0.1 roughness 0.1 }
}
#declare Hair = texture { pigment { rgb <0.05, 0.025, 0.015> } finish { Matt } }
#declare Lady = union {
    // The gown, a skirt that swings out
    sor {
        10
        <0.7, -0.1>, <0.62, 0.01>, <0.5, 0.2>, <0.36, 0.5>, <0.23, 0.8>
        <0.13, 1>, <0.115, 1.08>, <0.15, 1.25>, <0.12, 1.36>, <0.05, 1.42>
        open
        scale <1, 1, 0.85>
        texture { Silk }
    }
    sphere { 0, 0.1 scale <0.85, 1.15, 0.95> translate 1.57*y }
    cylinder { 1.33*y, 1.5*y, 0.042 }
    sphere_sweep {
        cubic_spline 5
        <-0.2, 1.2, 0>, 0.045 <-0.12, 1.33, 0>, 0.045 <-0.3, 1.28, 0.18>, 0.036
        <-0.22, 1.36, 0.36>, 0.03 <-0.1, 1.4, 0.5>, 0.03
    }
    sphere_sweep {
        cubic_spline 5
        <0, 1.3, 0>, 0.045 <0.12, 1.33, 0>, 0.045 <0.36, 1.27, 0.06>, 0.036
        <0.58, 1.44, 0.2>, 0.028 <0.7, 1.5, 0.25>, 0.025
    }
    sphere { 0, 0.105 scale <0.95, 1, 1> translate <0, 1.6, -0.025> texture { Hair } }
    sphere { <0, 1.66, -0.1>, 0.06 texture { Hair } }
    texture { Skin }
}
#declare Gentleman = union {
    sor {
        8
        <0.17, 0.6>, <0.2, 0.75>, <0.165, 1.02>, <0.19, 1.25>
        <0.215, 1.42>, <0.13, 1.52>, <0.06, 1.55>, <0.03, 1.6>
        scale <1, 1, 0.62>
    }
    sphere_sweep {
        cubic_spline 5
        <-0.1, 0.5, -0.14>, 0.07 <-0.08, 0.9, -0.03>, 0.1 <-0.09, 0.45, 0>, 0.075
        <-0.1, 0.05, 0.02>, 0.055 <-0.1, -0.2, 0.02>, 0.05
    }
    sphere_sweep {
        cubic_spline 5
        <0.1, 0.5, -0.14>, 0.07 <0.08, 0.9, -0.03>, 0.1 <0.1, 0.48, -0.08>, 0.075
        <0.12, 0.06, -0.2>, 0.055 <0.12, -0.2, -0.3>, 0.05
    }
    sphere_sweep {
        cubic_spline 5
        <0.1, 1.4, 0>, 0.065 <0.2, 1.4, 0>, 0.065 <0.34, 1.22, -0.12>, 0.05
        <0.12, 1.18, -0.33>, 0.04 <0, 1.2, -0.4>, 0.04
    }
    sphere_sweep {
        cubic_spline 5
        <-0.1, 1.4, 0>, 0.065 <-0.2, 1.4, 0>, 0.065 <-0.42, 1.3, -0.08>, 0.05
        <-0.6, 1.44, -0.18>, 0.038 <-0.7, 1.5, -0.2>, 0.03
    }
    cylinder { 1.5*y, 1.66*y, 0.05 texture { Skin } }
    sphere { 0, 0.1 scale <0.88, 1.18, 1> translate 1.72*y texture { Skin } }
    sphere { 0, 0.106 scale <0.92, 1, 1> translate <0, 1.765, 0.03> texture { Hair } }
    texture { Black }
}
union {
    object { Lady }
    object { Gentleman scale <-1, 1, 1> translate 0.4*z }
    rotate -50*y
    translate <0.2, 0, -4.2>
}

// The floor, of polished marble
box {
    <-6, -1, -14>, <6, 0, Far>
    pigment { checker rgb <0.62, 0.56, 0.48>, rgb <0.07, 0.045, 0.04> scale 0.95 rotate 45*y }
    finish { ambient 0 diffuse 0.7 reflection { 0.12, 0.9 fresnel } }
    interior { ior 1.8 }
}
