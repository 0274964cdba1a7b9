// SPDX-License-Identifier: CC0-1.0
// A street after the rain: lit windows, lamps, strings of bulbs from house to house and the lights
// of cars, some 750 luminaires, all of them again in the wet road.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 }
background { rgb <0.005, 0.008, 0.02> }

camera {
    location <1.1, 1.6, -9>
    right 4/3*x
    up y
    angle 60
    look_at <-0.3, 3.1, 10>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Iron = texture { pigment { rgb 0.08 } finish { Matt specular 0.2 } }

#macro Glow(Colour, Radiance)
    pigment { rgb Colour } finish { ambient 0 diffuse 0 emission Radiance }
#end

// A house with its front to -z: walls, windows, a shop below with an awning
#declare Pane = box { <-0.38, 0, -0.04>, <0.38, 1.15, 0.1> }
#declare Dark = object { Pane pigment { rgb 0.03 } finish { Matt reflection 0.15 } }
#declare Shop = box { <-0.85, 0, -0.04>, <0.85, 1.7, 0.1> }
#declare Open = object { Shop Glow(<1, 0.5, 0.18>, 3.5) }
#declare Shut = object { Shop pigment { rgb 0.05 } finish { Matt } }
#macro House(Wall, Lamp, Floors, Seed)
    union {
        box { <-3, 0, 0>, <3, 3.1 + 1.9*Floors, 6> pigment { rgb Wall } finish { Matt } }
        box {
            <-3.05, 3 + 1.9*Floors, -0.25>, <3.05, 3.2 + 1.9*Floors, 0.2>
            pigment { rgb Wall*0.7 }
            finish { Matt }
        }
        object {
            Light_Facade(object { Pane Glow(Lamp, 3.5) }, Dark, <4, Floors>, <1.4, 1.9>, 0.55, Seed)
            translate 3.3*y
        }
        object {
            Light_Facade(Open, Shut, <3, 1>, <1.95, 1>, 0.75, Seed + 50)
            translate 0.5*y
        }
        box {
            <-2.9, 2.35, -0.9>, <2.9, 2.42, 0>
            pigment { rgb Wall*<0.9, 0.35, 0.3> }
            finish { Matt }
        }
    }
#end

#declare Random = seed(12);
#for (I, 0, 9)
    #declare Wall = <0.5 + 0.2*rand(Random), 0.42 + 0.1*rand(Random), 0.3 + 0.15*rand(Random)>;
    object {
        House(Wall, <1, 0.42, 0.1>, 3 + int(3*rand(Random)), I)
        rotate -90*y
        translate <-6, 0, -6 + 6.2*I>
    }
    #declare Wall = <0.45 + 0.1*rand(Random), 0.4 + 0.15*rand(Random), 0.4 + 0.2*rand(Random)>;
    object {
        House(Wall, <1, 0.55, 0.2>, 3 + int(3*rand(Random)), I + 20)
        rotate 90*y
        translate <6, 0, -6 + 6.2*I>
    }
#end

// Street lamps, and strings of bulbs across
#declare Lamp = union {
    cylinder { <0, 0, 0>, <0, 3.6, 0>, 0.05 texture { Iron } }
    cylinder { <0, 3.6, 0>, <0.7, 3.75, 0>, 0.03 texture { Iron } }
    cone { <0.7, 3.66, 0>, 0.22, <0.7, 3.88, 0>, 0.03 texture { Iron } }
    sphere { <0.7, 3.62, 0>, 0.12 Glow(<1, 0.62, 0.26>, 110) }
}
object { Light_Street(Lamp, 9, 6.2, 8) translate -2.9*z }
#for (I, 0, 13)
    #declare Hooks = array[2] { <-6, 5.4, -1 + 4*I>, <6, 5.4 + 0.5*sin(3*I), 0.5 + 4*I> }
    object {
        Light_String(sphere { <0, -0.05, 0>, 0.045 Glow(<1, 0.6, 0.22>, 18) }, 36, Hooks, 0.09)
    }
#end

// The road, the kerbs, cars with their lights
plane { y, 0 pigment { rgb 0.12 } finish { Matt reflection 0.28 } }
box { <-6, 0, -20>, <-3.7, 0.12, 80> pigment { rgb 0.36 } finish { Matt reflection 0.06 } }
box { <3.7, 0, -20>, <6, 0.12, 80> pigment { rgb 0.36 } finish { Matt reflection 0.06 } }
#for (I, 0, 5)
    #declare Way = mod(I, 2)*2 - 1;
    union {
        box { <-0.75, 0.3, -1.7>, <0.75, 0.8, 1.7> }
        box { <-0.62, 0.8, -1>, <0.62, 1.3, 0.9> }
        #for (Side, -1, 1, 2)
            sphere {
                <0.55*Side, 0.6, -1.7>, 0.1 #if (Way > 0)
                Glow(<1, 0.03, 0.02>, 14) #else
                Glow(<1, 0.85, 0.6>, 60) #end
            }
        #end
        pigment { rgb 0.2 + 0.3*<rand(Random), rand(Random), rand(Random)> }
        finish { Matt phong 0.5 reflection 0.1 }
        translate <1.8*Way, 0, 2 + 5.5*I>
    }
#end
