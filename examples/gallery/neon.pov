// SPDX-License-Identifier: CC0-1.0
// A neon sign in the haze of an alley, and a cat that looks up at it. The tubes follow splines;
// each is a row of small luminaires, which light the wall, the wet stones and the air.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <1.6, 1.5, -8.6>
    right 16/9*x
    up y
    angle 62
    look_at <0, 1.8, 0>
    film {
        exposure 1.5
        response agx
        vignette 0.35
        glare { veil 0.16 halo 0.004 star 0 }
    }
}
media { scattering { 5, rgb 0.011 eccentricity 0.4 extinction 1 } samples 2 }

// A tube of light through the points, and the points with their x turned round
#macro Tube(Colour, Points)
    object {
        Light_Wire(Light_Spline_Track(Points, 0), 0.028)
        pigment { rgb Colour }
        finish { ambient 0 diffuse 0 emission 1 }
    }
#end
#macro Both(Colour, Points)
    object { Tube(Colour, Points) }
    object { Tube(Colour, Points) scale <-1, 1, 1> }
#end
#declare Light_Track_Pieces = 8;
#declare Teal = <0.3, 6, 7>;
#declare Pink = <8, 0.7, 3.5>;
#declare Amber = <11, 3.6, 0.4>;

// A candle that stands on an arm, with its flame
#macro Candle(Place)
    union {
        Tube(Teal, array[3] { <-0.24, 0.02, 0>, <0, -0.06, 0>, <0.24, 0.02, 0> })
        Tube(Pink, array[5] {
            <-0.09, 0.1, 0>, <-0.09, 0.7, 0>, <0, 0.76, 0>, <0.09, 0.7, 0>, <0.09, 0.1, 0>
        })
        Tube(Amber, array[7] {
            <0, 0.86, 0>, <0.12, 1, 0>, <0.07, 1.2, 0>, <0.02, 1.42, 0>, <-0.07, 1.2, 0>,
            <-0.12, 1, 0>, <0, 0.86, 0>
        })
        translate Place
    }
#end
union {
    Tube(Teal, array[4] { <0, 0.3, 0>, <0, 0.9, 0>, <0, 1.6, 0>, <0, 2.1, 0> })
    Both(Teal, array[4] { <0.03, 0.35, 0>, <0.2, 0.16, 0>, <0.55, 0.06, 0>, <0.75, -0.05, 0> })
    Tube(Teal, array[2] { <-0.75, -0.05, 0>, <0.75, -0.05, 0> })
    Both(Teal, array[6] {
        <0, 0.6, 0>, <0.5, 0.35, 0>, <1.15, 0.5, 0>, <1.5, 0.95, 0>, <1.55, 1.3, 0>, <1.55, 1.5, 0>
    })
    Both(Teal, array[5] {
        <0, 1.1, 0>, <0.35, 0.9, 0>, <0.68, 1.1, 0>, <0.78, 1.5, 0>, <0.78, 1.75, 0>
    })
    Both(Pink, array[6] {
        <0.2, 0.7, 0>, <0.42, 0.62, 0>, <0.55, 0.72, 0>, <0.48, 0.84, 0>, <0.38, 0.78, 0>,
        <0.42, 0.7, 0>
    })
    Candle(<0, 2.18, 0>)
    Candle(<0.78, 1.82, 0>)
    Candle(<-0.78, 1.82, 0>)
    Candle(<1.55, 1.57, 0>)
    Candle(<-1.55, 1.57, 0>)
    translate <-0.35, 1.1, -0.16>
}

// The wall, a drain pipe, and a door that is shut
#declare Matt = finish { ambient 0 diffuse 0.9 }
#declare Metal = texture {
    pigment { rgb <0.08, 0.08, 0.09> }
    finish { Matt specular 0.5 roughness 0.03 }
}
box {
    <-12, -1, 0>, <12, 12, 1>
    texture {
        pigment {
            brick
            pigment { rgb 0.3 }
            pigment {
                bozo
                scale <0.5, 0.16, 1>
                color_map { [0 rgb <0.3, 0.13, 0.09>] [1 rgb <0.55, 0.27, 0.2>] }
            }
            brick_size <0.5, 0.16, 0.5> mortar 0.018
        }
        normal {
            average
            normal_map {
                [1 brick 0.5
                 brick_size <0.5, 0.16, 0.5> mortar 0.018] [1 granite 0.25
                                                            scale 0.3]
            }
        }
        finish { Matt specular 0.15 roughness 0.08 }
    }
}
cylinder { <2.35, -1, -0.1>, <2.35, 12, -0.1>, 0.09 texture { Metal } }
#for (I, 0, 3)
    cylinder { <2.35, 0.6 + 1.7*I, -0.1>, <2.35, 0.72 + 1.7*I, -0.1>, 0.115 texture { Metal } }
#end
box {
    <-4.6, -1, -0.05>, <-3.1, 2.5, 0.1>
    pigment { rgb <0.05, 0.07, 0.07> }
    finish { Matt specular 0.3 roughness 0.03 }
}
box { <-4.75, -1, -0.1>, <-4.6, 2.65, 0.1> texture { Metal } }
box { <-3.1, -1, -0.1>, <-2.95, 2.65, 0.1> texture { Metal } }
box { <-4.75, 2.5, -0.1>, <-2.95, 2.65, 0.1> texture { Metal } }

// Wet cobbles
plane {
    y, 0
    pigment { rgb 0.035 }
    normal {
        average
        normal_map { [1 crackle 0.3 scale <0.35, 1, 0.25>] [1 bumps 0.3 scale <0.25, 1, 0.5>] }
    }
    finish { Matt specular 0.3 roughness 0.01 reflection { 0.1, 1 fresnel } }
    interior { ior 1.5 }
}

// The cat
union {
    sphere { 0, 1 scale <0.2, 0.3, 0.22> translate 0.28*y }
    sphere { 0, 1 scale <0.14, 0.24, 0.15> translate <0, 0.5, 0.04> }
    sphere { 0, 0.13 scale <1, 0.9, 1> translate <0, 0.78, 0.08> }
    cone { <-0.075, 0.84, 0.07>, 0.055, <-0.1, 0.98, 0.05>, 0.004 }
    cone { <0.075, 0.84, 0.07>, 0.055, <0.1, 0.98, 0.05>, 0.004 }
    sphere_sweep {
        cubic_spline 7 <0, 0, 0.3>, 0.05 <0.1, 0.06, -0.1>, 0.05 <0.3, 0.05, -0.22>,
        0.045 <0.5, 0.06, -0.1>, 0.04 <0.55, 0.12, 0.08>, 0.035 <0.5, 0.2, 0.12>,
        0.025 <0.4, 0.2, 0.2>, 0.02
    }
    pigment { rgb 0.012 }
    finish { Matt specular 0.2 roughness 0.05 }
    rotate 14*y
    translate <0.95, 0, -3.2>
}
