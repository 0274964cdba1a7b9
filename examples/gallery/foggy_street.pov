// SPDX-License-Identifier: CC0-1.0
// An avenue in the fog: 1000 lanterns on strings between the trees, each with a halo in the air.
// Every point of the air is lit by all of them; the light octree chooses which are asked.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.004, 0.006, 0.012> }

camera {
    location <0.9, 1.7, -11>
    right 4/3*x
    up y
    angle 58
    look_at <0, 2.9, 8>
    film {
        response agx
        exposure 0.2
        vignette 0.2
        glare { veil 0.06 halo 0.003 }
    }
}

// The fog: it scatters forward, and is densest above the ground.
media {
    scattering { 5, rgb <0.0095, 0.0105, 0.012> eccentricity 0.55 extinction 1 }
}

#declare Matt = finish { ambient 0 diffuse 0.9 }
#declare Bark = texture { pigment { rgb <0.09, 0.07, 0.055> } finish { Matt } }

// The road, a little wet
plane {
    y, 0
    pigment { rgb 0.07 }
    normal { bumps 0.05 scale <0.4, 1, 0.9> }
    finish { Matt reflection { 0.05, 0.5 fresnel } }
    interior { ior 1.33 }
}

// Trees without leaves, as forks of cones
#macro Branch(Length, Thick, Level, Seed)
    union {
        cone { 0, Thick, Length*y, 0.62*Thick }
        #if (Level > 0)
            #local Turn = rand(Seed)*360;
            #for (I, 0, 2)
                object {
                    Branch(Length*(0.62 + 0.16*rand(Seed)), 0.58*Thick, Level - 1, Seed)
                    rotate (24 + 26*rand(Seed))*z
                    rotate (Turn + I*120 + 40*rand(Seed))*y
                    translate Length*(0.72 + 0.24*I/2)*y
                }
            #end
        #end
    }
#end
#declare Random = seed(5);
#declare Trees = array[4];
#for (I, 0, 3)
    #declare Trees[I] = object { Branch(2.5, 0.2, 4, Random) texture { Bark } }
#end
#for (I, 0, 12)
    #for (Side, -1, 1, 2)
        object {
            Trees[int(4*rand(Random))]
            rotate 360*rand(Random)*y
            scale 0.9 + 0.3*rand(Random)
            translate <Side*(4.7 + 0.5*rand(Random)), 0, -9 + 5.2*I>
        }
    #end
#end

// Lanterns: 25 strings of 40
#declare Colours = array[5] {
    <1, 0.52, 0.16>, <1, 0.36, 0.09>, <1, 0.62, 0.3>, <1, 0.25, 0.12>, <1, 0.7, 0.42>
}
#for (I, 0, 24)
    #local Left = <-4.6, 4.1 + 0.7*rand(Random), -8 + 2.6*I>;
    #local Right = <4.6, 4.1 + 0.7*rand(Random), -8 + 2.6*I + 1.6*(rand(Random) - 0.5)>;
    #local Sag = 0.5 + 0.5*rand(Random);
    #for (J, 0, 39)
        #local At = (J + 0.5)/40;
        sphere {
            Left + At*(Right - Left) - Sag*4*At*(1 - At)*y, 0.05
            pigment { rgb Colours[int(5*rand(Random))] }
            finish { ambient 0 diffuse 0 emission 24 }
        }
    #end
#end

// Somebody is out
#declare Cloth = texture { pigment { rgb <0.03, 0.03, 0.04> } finish { Matt } }
union {
    sphere { 1.62*y, 0.12 }
    cone { 0.75*y, 0.27, 1.5*y, 0.15 }
    cylinder { <-0.09, 0, 0>, <-0.1, 0.8, 0>, 0.075 }
    cylinder { <0.1, 0, 0.16>, <0.08, 0.8, 0>, 0.075 }
    texture { Cloth }
    translate <-0.5, 0, 3>
}
