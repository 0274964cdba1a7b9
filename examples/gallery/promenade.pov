// SPDX-License-Identifier: CC0-1.0
// A promenade by the water at night, as a camera with six blades sees it: some 430 luminaires, each
// as bright as lamps are, with their glare on film. `candelabra develop` tries other films without
// rendering again.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.0012, 0.002, 0.0055> }

camera {
    location <-1.7, 1.65, -8.2>
    right 16/9*x
    up y
    angle 56
    look_at <0.9, 2.2, 8>
    film {
        exposure 1.3
        response agx
        white_balance 5200
        pixel_filter blackman_harris
        vignette 0.3
        glare { veil 0.14 halo 0.006 star 0.018 blades 6 angle 12 length 0.35 }
    }
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Iron = texture { pigment { rgb 0.05 } finish { Matt specular 0.3 roughness 0.02 } }
#macro Glow(Colour, Radiance)
    pigment { rgb Colour } finish { ambient 0 diffuse 0 emission Radiance }
#end

// Lamps with two arms, which follow the quay
#declare Lamp = union {
    cylinder { <0, 0, 0>, <0, 0.5, 0>, 0.11 texture { Iron } }
    cylinder { <0, 0.5, 0>, <0, 3.5, 0>, 0.045 texture { Iron } }
    cylinder { <-0.55, 3.35, 0>, <0.55, 3.35, 0>, 0.025 texture { Iron } }
    #for (Side, -1, 1, 2)
        cylinder { <0.55*Side, 3.35, 0>, <0.55*Side, 3.5, 0>, 0.05 texture { Iron } }
        sphere { <0.55*Side, 3.63, 0>, 0.14 Glow(<1, 0.66, 0.32>, 130) }
    #end
}
#for (I, 1, 11)
    object { Lamp translate <0.012*I*I + 0.7, 0, -4.2 + 4.6*I> }
#end

// Strings of bulbs between them, in the colours of a feast
#declare Colours = array[4] {
    <1, 0.16, 0.05>, <1, 0.62, 0.2>, <0.12, 0.85, 0.3>, <0.15, 0.35, 1>
}
#for (I, 0, 9)
    #declare From = <0.012*I*I + 0.15, 3.3, -4.2 + 4.6*I>;
    #declare To = <0.012*(I + 1)*(I + 1) + 0.15, 3.3, 0.4 + 4.6*I>;
    #for (K, 1, 17)
        #declare T = K/18;
        sphere {
            From + (To - From)*T - 2.2*T*(1 - T)*y, 0.035
            Glow(Colours[mod(K + I, 4)], 9)
        }
    #end
#end

// The quay: wet stones, a wall towards the water, benches
plane { y, 0 pigment { rgb 0.1 } finish { Matt reflection 0.16 } normal { bumps 0.06 scale 0.12 } }
box { <1.25, 0, -30>, <1.6, 0.5, 90> pigment { rgb <0.2, 0.19, 0.18> } finish { Matt } translate 1.2*x }
#for (I, 0, 6)
    union {
        box { <-0.75, 0.4, -0.22>, <0.75, 0.46, 0.22> }
        box { <-0.75, 0.55, 0.2>, <0.75, 0.95, 0.25> }
        box { <-0.65, 0, -0.2>, <-0.58, 0.42, 0.2> }
        box { <0.58, 0, -0.2>, <0.65, 0.42, 0.2> }
        pigment { rgb <0.16, 0.09, 0.04> }
        finish { Matt }
        rotate -90*y
        translate <-3.3, 0, -3 + 6.5*I>
    }
#end

// The water, and a far shore with its windows and their light in it
difference {
    box { <2.8, -0.5, -40>, <220, 0.02, 260> }
    box { <2.7, -2, -41>, <2.8, 1, 261> }
    pigment { rgb <0.002, 0.004, 0.006> }
    finish { Matt specular 0 reflection { 0.15, 0.85 fresnel } }
    interior { ior 1.33 }
    normal { bumps 0.12 scale <0.5, 1, 0.9> }
}
#declare Random = seed(7);
#for (I, 0, 25)
    #declare Tall = 3 + 9*pow(rand(Random), 2);
    #declare Wide = 5 + 5*rand(Random);
    #declare Place = <-30 + 8*I, 0, 118 + 18*rand(Random)>;
    box {
        Place - Wide/2*x, Place + <Wide/2, Tall, 8>
        pigment { rgb 0.02 } finish { Matt }
    }
    #for (K, 1, 9)
        #declare At = Place + <Wide*(rand(Random) - 0.5)*0.9, 0.8 + (Tall - 1.2)*rand(Random), -0.1>;
        box {
            At - <0.22, 0.3, 0.05>, At + <0.22, 0.3, 0.05>
            Glow(<1, 0.5 + 0.3*rand(Random), 0.18 + 0.4*rand(Random)>, 6 + 22*pow(rand(Random), 2))
        }
    #end
#end
