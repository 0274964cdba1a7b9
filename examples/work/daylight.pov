// SPDX-License-Identifier: CC0-1.0
// A room of 6 by 5 metres by daylight: Berlin, 21 September, half past three in the afternoon. The sun and the sky
// have the luminances that they have there on a clear day. With Overcast=1 it is a dull day, as the daylight factor wants it.
//   candelabra daylight.pov
//   candelabra daylight.pov Declare=Overcast=1 --measure daylight.csv
#version 3.7;
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 1000 }
    integrator { path_traced bounces 6 }
}
#default { finish { ambient 0 diffuse 1 } }

// Windows face south, which is -z here; the sun comes in from the right.
#ifndef (Overcast) #declare Overcast = 0; #end
sky_luminance {
    #if (Overcast) overcast #else clear #end
    place <52.5, 13.4> date <2026, 9, 21> time 15.5 zone 2
    north z
    ground 0.15
}

camera {
    location <0.35, 1.6, 4.75>
    right 3/2*x up y angle 78
    look_at <3.9, 1.05, 0.4>
    film { exposure auto key 0.4 response agx }
}

#declare Long = 6; #declare Deep = 5; #declare High = 2.75;
#declare Wall = texture { pigment { rgb <0.78, 0.76, 0.72> } }

// ---- the room
box { <0, High, 0>, <Long, High + 0.2, Deep> pigment { rgb 0.85 } }
box { <-0.2, 0, 0>, <0, High, Deep> texture { Wall } }
box { <Long, 0, 0>, <Long + 0.2, High, Deep> pigment { rgb <0.5, 0.58, 0.55> } }
box { <-0.2, 0, Deep>, <Long + 0.2, High, Deep + 0.2> texture { Wall } }
// a floor of boards
#declare Stream = seed(4);
#for (I, 0, 39)
    #local From = -1.2*rand(Stream);
    #for (K, 0, 4)
        #local Tone = 0.8 + 0.4*rand(Stream);
        box { <From + 1.5*K, -0.05, 0>, <From + 1.5*K + 1.496, 0, 0.122>
            translate 0.125*I*z pigment { rgb Tone*<0.36, 0.23, 0.13> } finish { specular 0.05 roughness 0.05 } }
    #end
#end
box { <-0.2, -0.2, -0.3>, <Long + 0.2, -0.05, Deep + 0.2> pigment { rgb 0.2 } }

// ---- the wall with three windows
#declare Sill = 0.75; #declare Lintel = 2.45;
box { <-0.2, 0, -0.3>, <Long + 0.2, Sill, 0> texture { Wall } }
box { <-0.2, Lintel, -0.3>, <Long + 0.2, High, 0> texture { Wall } }
#declare Frame = texture { pigment { rgb 0.82 } }
#for (I, 0, 3)
    box { <-0.2 + 1.87*I, Sill, -0.3>, <0.59 + 1.87*I, Lintel, 0> texture { Wall } }
#end
#for (I, 0, 2)
    union {
        box { <0.58, Sill, -0.14>, <1.68, Sill + 0.06, -0.08> }
        box { <0.58, Lintel - 0.06, -0.14>, <1.68, Lintel, -0.08> }
        box { <0.58, Sill, -0.14>, <0.64, Lintel, -0.08> }
        box { <1.62, Sill, -0.14>, <1.68, Lintel, -0.08> }
        box { <1.1, Sill, -0.14>, <1.16, Lintel, -0.08> }
        box { <0.58, 1.85, -0.13>, <1.68, 1.88, -0.09> }
        box { <0.5, Sill - 0.03, -0.08>, <1.76, Sill, 0.12> }
        texture { Frame }
        translate 1.87*I*x
    }
#end

// ---- furniture
#declare Oak = texture { pigment { rgb <0.5, 0.33, 0.18> } finish { specular 0.1 roughness 0.03 } }
#declare Leg = 0.72;
union {
    box { <-0.9, 0.72, -0.42>, <0.9, 0.75, 0.42> }
    #for (I, 0, 3) box { <-0.03, 0, -0.03>, <0.03, 0.72, 0.03> translate <(mod(I, 2) - 0.5)*1.66, 0, (int(I/2) - 0.5)*0.72> } #end
    texture { Oak } translate <3.4, 0, 1.7>
}
// a book, a bowl of apples, a vase, between the points of the meter
box { <-0.11, 0.75, -0.15>, <0.11, 0.775, 0.15> rotate 20*y translate <2.8, 0, 1.56> pigment { rgb <0.55, 0.1, 0.08> } }
difference {
    sphere { 0, 0.17 scale <1, 0.55, 1> }
    sphere { 0, 0.155 scale <1, 0.55, 1> }
    box { <-1, 0.02, -1>, <1, 1, 1> }
    translate <3.4, 0.85, 1.84> pigment { rgb 0.85 } finish { specular 0.4 roughness 0.01 }
}
#for (I, 0, 4)
    sphere { 0, 0.042 translate 0.075*x rotate 72*I*y translate <3.4, 0.84, 1.84>
        pigment { rgb <0.6 - 0.06*I, 0.12 + 0.09*I, 0.05> } finish { specular 0.3 roughness 0.03 } }
#end
lathe { cubic_spline 7, <0, -0.01>, <0.05, 0>, <0.075, 0.08>, <0.045, 0.2>, <0.03, 0.24>, <0.045, 0.28>, <0.05, 0.3>
    translate <4, 0.75, 1.55> pigment { rgb <0.15, 0.32, 0.42> } finish { specular 0.5 roughness 0.008 } }
#declare Chair = union {
    box { <-0.22, 0.43, -0.22>, <0.22, 0.46, 0.22> }
    box { <-0.22, 0.62, 0.19>, <0.22, 0.86, 0.21> rotate 4*x }
    #for (I, 0, 3) cylinder { 0, 0.45*y, 0.018 translate <(mod(I, 2) - 0.5)*0.38, 0, (int(I/2) - 0.5)*0.38> } #end
    #for (I, 0, 1) cylinder { 0.45*y, 0.86*y, 0.016 translate <(I - 0.5)*0.38, 0, 0.2> } #end
    texture { Oak }
}
object { Chair translate <3, 0, 2.45> }
object { Chair rotate 15*y translate <3.95, 0, 2.5> }
object { Chair rotate 185*y translate <3.5, 0, 0.95> }
// a sofa on the right wall, pictures, a rug, a lamp that is off
union {
    superellipsoid { <0.2, 0.2> scale <0.42, 0.2, 0.95> translate <0, 0.24, 0> }
    superellipsoid { <0.2, 0.2> scale <0.14, 0.36, 0.95> rotate 8*z translate <0.36, 0.5, 0> }
    superellipsoid { <0.2, 0.2> scale <0.42, 0.29, 0.12> translate <0, 0.3, 0.95> }
    superellipsoid { <0.2, 0.2> scale <0.42, 0.29, 0.12> translate <0, 0.3, -0.95> }
    pigment { rgb <0.16, 0.26, 0.34> } translate <Long - 0.55, 0, 2.6>
}
box { <Long - 0.02, 1.35, 2.1>, <Long, 1.95, 3.1> pigment { rgb <0.08, 0.07, 0.06> } }
box { <Long - 0.025, 1.4, 2.15>, <Long - 0.02, 1.9, 3.05>
    pigment { gradient z color_map { [0 rgb <0.8, 0.45, 0.2>] [0.5 rgb <0.85, 0.8, 0.6>] [1 rgb <0.2, 0.35, 0.5>] } scale 0.9 translate 2.15*z } }
box { <2, 0, 0.7>, <4.8, 0.012, 2.9> pigment { rgb <0.48, 0.42, 0.34> } }
// leaves of a plant by the window
cone { <0.55, 0, 0.6>, 0.15, <0.55, 0.36, 0.6>, 0.19 pigment { rgb <0.62, 0.33, 0.22> } }
#for (I, 0, 70)
    sphere { 0, 1 scale <0.19, 0.008, 0.06> translate 0.19*x rotate (10 + 70*rand(Stream))*z rotate 137.5*I*y
        translate <0.55, 0.4 + 0.75*rand(Stream), 0.6> pigment { rgb <0.07, 0.2 + 0.1*rand(Stream), 0.05> } }
#end

// ---- outside: a lawn, a hedge, trees and a house over the way
plane { y, -0.4 pigment { rgb <0.09, 0.15, 0.05> } }
box { <-30, -0.4, -9>, <40, 0.5, -8> pigment { bozo color_map { [0 rgb <0.03, 0.07, 0.02>] [1 rgb <0.1, 0.17, 0.05>] } scale 0.2 } }
#for (I, 0, 5)
    #local At = <-9 + 5.5*I + 2*rand(Stream), -0.4, -14 - 9*rand(Stream)>;
    cylinder { At, At + 2.5*y, 0.15 pigment { rgb <0.12, 0.08, 0.05> } }
    #for (K, 0, 60)
        sphere { At + <2.6*(rand(Stream) - 0.5), 2 + 2.8*rand(Stream), 2.6*(rand(Stream) - 0.5)>, 0.3 + 0.3*rand(Stream)
            pigment { rgb <0.06, 0.12 + 0.07*rand(Stream), 0.03> } }
    #end
#end
union {
    box { <-6, -0.4, 0>, <6, 4.6, 8> pigment { rgb <0.72, 0.6, 0.42> } }
    prism { linear_spline 0, 12, 4, <-0.5, 4.5>, <8.5, 4.5>, <4, 7.4>, <-0.5, 4.5> rotate <-90, 0, 0> rotate <0, -90, 0> translate -6*x
        pigment { rgb <0.36, 0.13, 0.08> } }
    translate <16, 0, -42>
}

// ---- what is measured
meter { "desk height" daylight_factor corner <0.5, 0.75, 0.5> along 5*x across 4*z counts <5, 4> }
meter { "table" corner <2.5, 0.76, 1.28> along 1.8*x across 0.84*z counts <6, 3> }
