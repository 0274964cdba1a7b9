// SPDX-License-Identifier: CC0-1.0
// A football pitch of 105 by 68 metres by night: four masts of 22 metres with eight floodlights of 120000 lm each. The
// meters ask for the 75 lx and the uniformity of 0.5 of class III of EN 12193, and for the light on players' faces. Only a
// sixth of the light of panes without reflectors falls on the pitch.
//   candelabra pitch.pov --measure pitch.csv
//   candelabra pitch.pov +Opitch.exr --layers illuminance,luminance
//   candelabra develop pitch.exr --false-colour lux --isolines -o pitch_lux.png
#version 3.7;
#include "luminaires.inc"
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 40 }
    integrator { path_traced bounces 3 }
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location <-38, 13, -62>
    right 16/9*x up y angle 60
    look_at <2, 1, -4>
    film { exposure auto response agx }
}
background { rgb <0.001, 0.0014, 0.003> }

// ---- the ground: mown in stripes, white lines
plane { y, -0.02 pigment { bozo color_map { [0 rgb <0.05, 0.08, 0.03>] [1 rgb <0.09, 0.1, 0.05>] } scale 3 } }
#for (I, 0, 19)
    box { <-55 + 5.5*I, -0.1, -37>, <-49.5 + 5.5*I, 0, 37>
        pigment { bozo color_map { [0 rgb (mod(I, 2) ? 0.85 : 1)*<0.07, 0.17, 0.04>] [1 rgb (mod(I, 2) ? 0.85 : 1)*<0.1, 0.22, 0.06>] } scale 0.3 } }
#end
#declare Paint = pigment { rgb 0.8 }
#macro Line(A, B) box { A - <0.06, 0.01, 0.06>, B + <0.06, 0.004, 0.06> pigment { Paint } } #end
#macro Frame(A, B)
    Line(<A.x, 0, A.z>, <B.x, 0, A.z>) Line(<A.x, 0, B.z>, <B.x, 0, B.z>)
    Line(<A.x, 0, A.z>, <A.x, 0, B.z>) Line(<B.x, 0, A.z>, <B.x, 0, B.z>)
#end
Frame(<-52.5, 0, -34>, <52.5, 0, 34>)
Line(<0, 0, -34>, <0, 0, 34>)
difference { cylinder { 0, 0.004*y, 9.21 } cylinder { -y, y, 9.09 } pigment { Paint } }
#for (I, -1, 1, 2)
    Frame(<min(I*52.5, I*36), 0, -20.16>, <max(I*52.5, I*36), 0, 20.16>)
    Frame(<min(I*52.5, I*47), 0, -9.16>, <max(I*52.5, I*47), 0, 9.16>)
    // a goal with its net
    union {
        cylinder { <0, 0, -3.66>, <0, 2.44, -3.66>, 0.06 }
        cylinder { <0, 0, 3.66>, <0, 2.44, 3.66>, 0.06 }
        cylinder { <0, 2.44, -3.66>, <0, 2.44, 3.66>, 0.06 }
        #for (K, 0, 24)
            cylinder { <0.7, 2.4, -3.6 + 0.3*K>, <2, 0, -3.6 + 0.3*K>, 0.008 }
            cylinder { <0, 2.44, -3.6 + 0.3*K>, <0.7, 2.4, -3.6 + 0.3*K>, 0.008 }
        #end
        #for (K, 0, 8)
            cylinder { <0.7 + 1.3*K/8, 2.4 - 0.3*K, -3.6>, <0.7 + 1.3*K/8, 2.4 - 0.3*K, 3.6>, 0.008 }
        #end
        scale <I, 1, 1> translate 52.5*I*x pigment { rgb 0.85 }
    }
#end

// ---- players, the referee and the ball
#declare Stream = seed(8);
#macro Player(Shirt, Shorts)
    union {
        #local Step = 12 + 28*rand(Stream);
        #for (I, -1, 1, 2)
            union {
                cylinder { 0, -0.42*y, 0.075 pigment { rgb <0.5, 0.33, 0.24> } }
                cylinder { -0.42*y, -0.85*y, 0.055 pigment { rgb Shirt } }
                sphere { 0, 0.055 scale <1, 0.8, 2.2> translate <0, -0.87, 0.05> pigment { rgb 0.04 } }
                rotate Step*I*x translate <0.1*I, 0.92, 0>
            }
            union {
                cylinder { 0, -0.28*y, 0.055 pigment { rgb Shirt } }
                cylinder { -0.28*y, <0, -0.5, 0.12>, 0.04 pigment { rgb <0.5, 0.33, 0.24> } }
                rotate <-Step*I, 0, 14*I> translate <0.22*I, 1.45, 0>
            }
        #end
        superellipsoid { <0.6, 0.6> scale <0.2, 0.16, 0.13> translate 0.93*y pigment { rgb Shorts } }
        superellipsoid { <0.7, 0.5> scale <0.22, 0.3, 0.13> translate 1.25*y pigment { rgb Shirt } }
        cylinder { 1.5*y, 1.6*y, 0.05 pigment { rgb <0.5, 0.33, 0.24> } }
        sphere { 1.68*y, 0.105 pigment { rgb <0.5, 0.33, 0.24> } }
        sphere { <0, 1.71, -0.02>, 0.105 pigment { rgb <0.06, 0.04, 0.03> } }
        rotate 360*rand(Stream)*y
    }
#end
#for (I, 0, 9)
    object { Player(<0.6, 0.04, 0.03>, 0.75) translate <-30 + 48*rand(Stream), 0, -26 + 50*rand(Stream)> }
    object { Player(<0.75, 0.75, 0.72>, <0.03, 0.04, 0.12>) translate <-30 + 48*rand(Stream), 0, -26 + 50*rand(Stream)> }
#end
object { Player(<0.05, 0.05, 0.05>, 0.05) translate <-12, 0, -14> }
object { Player(<0.1, 0.4, 0.15>, <0.1, 0.4, 0.15>) translate <-50.5, 0, 0.6> }
sphere { <-15.5, 0.11, -11>, 0.11 pigment { rgb 0.85 } }

// ---- a stand on the far side, with people, and boards
#for (I, 0, 6)
    box { <-40, 0, 40 + 0.9*I>, <40, 0.5 + 0.45*I, 40.9 + 0.9*I> pigment { rgb 0.4 } }
    #for (K, 0, 110)
        #if (rand(Stream) < 0.6)
            union {
                superellipsoid { <0.7, 0.7> scale <0.22, 0.36, 0.18> translate 0.35*y pigment { rgb <0.1 + 0.6*rand(Stream), 0.1 + 0.4*rand(Stream), 0.1 + 0.5*rand(Stream)> } }
                sphere { 0.85*y, 0.12 pigment { rgb <0.5, 0.35, 0.27> } }
                translate <-39 + 0.7*K, 0.5 + 0.45*I, 40.5 + 0.9*I>
            }
        #end
    #end
#end
box { <-41, 0, 46.5>, <41, 7.5, 46.8> pigment { rgb <0.3, 0.32, 0.35> } }
box { <-41, 7.2, 39.5>, <41, 7.5, 46.8> pigment { rgb 0.3 } }
#for (I, 0, 15)
    box { <-52 + 6.5*I, 0, 37>, <-45.7 + 6.5*I, 0.95, 37.1>
        pigment { rgb <0.15 + 0.5*mod(I, 3)/2, 0.15 + 0.3*mod(I + 1, 3)/2, 0.2 + 0.4*mod(I + 2, 3)/2> } }
#end
// trees behind
#for (I, 0, 30)
    sphere { 0, 1 scale <4 + 2*rand(Stream), 5 + 3*rand(Stream), 4> translate <-90 + 6*I, 4, 62 + 10*rand(Stream)> pigment { rgb <0.03, 0.06, 0.03> } }
#end

// ---- the masts at the corners; each floodlight aims at a place of its own
#for (K, 0, 3)
    #local Foot = <(mod(K, 2) ? 57 : -57), 0, (K < 2 ? -42 : 42)>;
    cone { Foot, 0.4, Foot + 22*y, 0.2 texture { Luminaire_Metal } }
    #for (I, 0, 7)
        #local At = Foot + <0.9*(mod(I, 4) - 1.5)*(mod(K, 2) ? -1 : 1), 21 + 1.1*int(I/4), 0>;
        #local Aim = <(mod(K, 2) ? 1 : -1)*(6 + 13*mod(I, 4)), 0, (K < 2 ? -1 : 1)*(6 + 14*int(I/4))>;
        #local To = Aim - At;
        object {
            Luminaire_Flood(120000, 5700)
            rotate degrees(atan2(-To.y, vlength(<To.x, 0, To.z>)))*x
            rotate degrees(atan2(To.x, To.z))*y
            translate At
        }
    #end
#end

// ---- what is measured
meter { "pitch" corner <-52.5, 0.02, -34> along 105*x across 68*z counts <15, 10> direction y }
meter { "faces" semi_cylindrical corner <-52.5, 1.5, -34> along 105*x across 68*z counts <8, 5> direction -z }
meter { "keeper" ugr points { 1, <-50, 1.7, 0> } direction <1, 0, 0> }
