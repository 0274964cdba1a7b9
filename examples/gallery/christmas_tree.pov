// SPDX-License-Identifier: CC0-1.0
// A Christmas tree with 500 LEDs at the tips of its twigs, in the snow. The positions and colours
// are two arrays that a seeded loop fills; Declare=Seed=... hangs the lights differently,
// Declare=Leds=... more.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.004, 0.007, 0.018> }

#ifndef (Leds) #declare Leds = 500; #end
#ifndef (Seed) #declare Seed = 24; #end

camera {
    location <0, 1.9, -8.6>
    right 3/4*x
    up y
    angle 33
    look_at <0, 2.2, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Snow = texture { pigment { rgb <0.8, 0.83, 0.88> } finish { Matt } }
#declare Random = seed(Seed);

// The tree: 2600 twigs wind round the trunk by the golden angle, shorter and shorter
#declare Twigs = 2600;
#declare Tips = array[Twigs];
cylinder { <0, 0, 0>, <0, 4.3, 0>, 0.09 pigment { rgb <0.2, 0.12, 0.07> } finish { Matt } }
union {
    #for (I, 0, Twigs - 1)
        #declare Part = pow(I/Twigs, 0.8);
        #declare Foot = <0, 0.6 + 3.8*Part, 0>;
        #declare Reach = (1.55*(1 - Part) + 0.06)*(0.72 + 0.28*rand(Random));
        #declare Tips[I] = Foot + vrotate(<Reach, -0.28*Reach, 0>, 137.508*I*y);
        cone { Foot, 0.05, Tips[I], 0.012 }
        #declare Middle = 0.45*Foot + 0.55*Tips[I];
        #for (Side, -1, 1, 2)
            #declare Aside = vrotate(<0.32*Reach, -0.08, 0.2*Reach*Side>, 137.508*I*y);
            cone { Middle, 0.03, Middle + Aside, 0.008 }
        #end
    #end
    pigment { rgb <0.1, 0.3, 0.13> }
    finish { Matt }
}

#declare Palette = array[5] {
    <1, 0.04, 0.03>, <1, 0.3, 0.03>, <0.05, 0.9, 0.1>, <0.04, 0.12, 1>, <0.9, 0.05, 0.5>
}
#declare Points = array[Leds];
#declare Colours = array[Leds];
#for (I, 0, Leds - 1)
    #declare Points[I] = Tips[int((I + rand(Random))*Twigs/Leds)]*1.02;
    #declare Colours[I] = rgb Palette[int(5*rand(Random))];
#end
object { Light_Positions_Coloured(sphere { <0, 0, 0>, 0.032 }, Points, Colours, 24) }

// A star of warm light on the top
union {
    #for (I, 0, 4)
        cone { <0, 0, 0>, 0.075, <0, 0.26, 0>, 0 rotate 72*I*z }
    #end
    pigment { rgb <1, 0.6, 0.2> }
    finish { ambient 0 diffuse 0 emission 5 }
    translate 4.55*y
}

plane { y, 0 texture { Snow } }
sphere { <-7, -12.4, 9>, 14 texture { Snow } }
sphere { <9, -16.7, 12>, 18.5 texture { Snow } }

// Presents on both sides, where the tree lights them
#for (I, 0, 7)
    union {
        box { <-0.22, 0, -0.22>, <0.22, 0.3, 0.22> pigment { rgb 0.3 + 0.4*Palette[mod(I, 5)] } }
        box { <-0.04, 0, -0.225>, <0.04, 0.305, 0.225> pigment { rgb 0.8 } }
        finish { Matt }
        scale 0.75 + 0.5*rand(Random)
        rotate 360*rand(Random)*y
        translate vrotate((1.75 + 0.3*rand(Random))*x, (div(I, 4)*180 - 38 + 25*mod(I, 4))*y)
    }
#end
