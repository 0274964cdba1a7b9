// SPDX-License-Identifier: CC0-1.0
// A Ferris wheel at the waterside with some 2200 coloured bulbs along its rims and spokes.
#version 3.7;
#include "colors.inc"
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.004, 0.006, 0.016> }

camera {
    location <-5.5, 2, -21>
    right 4/3*x
    up y
    angle 52
    look_at <0, 4.3, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Steel = texture { pigment { rgb 0.55 } finish { Matt specular 0.3 } }
#declare Spokes = 16;
#declare Radius = 5;

#macro Bulb(Colour)
    sphere { <0, 0, 0>, 0.05 pigment { Colour } finish { ambient 0 diffuse 0 emission 8 } }
#end
#macro Hue(Turn)
    (0.04 + CH2RGB(360*Turn)*<1, 0.7, 1>)
#end

#declare Gondola = union {
    cylinder { <0, -0.75, 0>, <0, -0.35, 0>, 0.34 }
    cone { <0, 0, 0>, 0.05, <0, -0.2, 0>, 0.4 }
    #for (I, 0, 3)
        cylinder { <0.3, -0.4, 0>, <0.3, -0.15, 0>, 0.02 rotate (45 + 90*I)*y }
    #end
    object { Light_Ring(Bulb(rgb <1, 0.55, 0.2>), 14, 0.4) translate -0.22*y }
}

#declare Wheel = union {
    #for (Side, -1, 1, 2)
        #for (I, 0, Spokes - 1)
            union {
                object {
                    Light_Line(Bulb(rgb Hue(I/Spokes)), 30, 0.7*x, Radius*x)
                    translate 0.65*Side*z
                }
                cylinder { <0, 0, 0.57*Side>, <Radius, 0, 0.57*Side>, 0.03 texture { Steel } }
                rotate 360*I/Spokes*z
            }
        #end
        object {
            Light_Ring(Bulb(rgb <1, 0.22, 0.03>), 300, Radius)
            rotate 90*x
            translate 0.58*Side*z
        }
        object {
            Light_Ring(Bulb(rgb <0.03, 0.1, 1>), 150, 0.6*Radius)
            rotate 90*x
            translate 0.64*Side*z
        }
        object { Light_Ring(Bulb(rgb <1, 0.03, 0.1>), 44, 0.7) rotate 90*x translate 0.75*Side*z }
    #end
}

union {
    object { Wheel rotate 7*z }
    cylinder { <0, 0, -0.9>, <0, 0, 0.9>, 0.3 texture { Steel } }
    #for (I, 0, Spokes - 1)
        object {
            Gondola
            pigment { rgb 0.25 + 0.5*CH2RGB(360*I/Spokes) }
            finish { Matt }
            translate vrotate(Radius*x, (7 + 360*I/Spokes)*z)
        }
    #end
    // Legs
    #for (I, 0, 3)
        #declare Front = mod(I, 2) - 0.5;
        #declare Left = div(I, 2) - 0.5;
        cylinder { <0, 0, 1.9*Front>, <5.4*Left, -6.1, 3.6*Front>, 0.16 texture { Steel } }
    #end
    translate 6.2*y
}

// The quay with its lamps, and the water in front of it
box { <-60, -1, -3>, <60, 0.05, 40> pigment { rgb <0.42, 0.38, 0.34> } finish { Matt } }
plane { y, -0.5 pigment { rgb <0.02, 0.035, 0.05> } finish { ambient 0 diffuse 1 reflection 0.55 } }
#declare Quay_Lamp = union {
    object { Bulb(rgb <1, 0.6, 0.25>) scale 2 translate 1.2*y }
    cylinder { <0, 0, 0>, <0, 1.12, 0>, 0.03 texture { Steel } }
}
object { Light_Line(Quay_Lamp, 21, <-20, 0, -2.6>, <20, 0, -2.6>) }

// The town behind
#declare Pane = box { <-0.2, 0, 0>, <0.2, 0.4, 0.1> }
#declare Lit = object {
    Pane
    pigment { rgb <1, 0.45, 0.12> }
    finish { ambient 0 diffuse 0 emission 2 }
}
#declare Dark = object { Pane pigment { rgb 0.02 } finish { Matt } }
#for (I, 0, 9)
    object {
        Light_Facade(Lit, Dark, <4, 3 + mod(I*5, 4)>, <0.8, 0.9>, 0.5, I)
        translate <-22 + 4.9*I, 0.5, 16>
    }
#end
