// SPDX-License-Identifier: CC0-1.0
// A street with lamps of 9000 lm on masts of 8 metres, 30 metres apart, on one side. The meters ask what EN 13201 asks of
// class M4 and of the pavement: 0.75 cd/m2 with uniformities of 0.4 and 0.6, a threshold increment below 15 %, and 7.5 lx.
// There is light enough, but panes without lenses leave dark places between the masts, and fail the uniformity.
//   candelabra street.pov --measure street.csv
//   candelabra street.pov +Ostreet.exr --layers illuminance,luminance
//   candelabra develop street.exr --false-colour lux --isolines -o street_lux.png
#version 3.7;
#include "luminaires.inc"
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 4 }
    integrator { path_traced bounces 3 }
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location <3.4, 1.65, -24>
    right 16/9*x up y angle 64
    look_at <4.2, 2.3, 10>
    film { exposure auto response agx }
}
sky_sphere { pigment { gradient y color_map { [0 rgb <0.03, 0.028, 0.03>] [0.5 rgb <0.004, 0.006, 0.014>] } } }

// ---- the road, 7 metres wide, along z; pavements and fronts of houses on both sides
#declare Asphalt = pigment { granite color_map { [0 rgb 0.11] [0.5 rgb 0.2] [1 rgb 0.26] } scale 0.4 }
#declare Stone = pigment { granite color_map { [0 rgb 0.22] [1 rgb 0.4] } scale 0.3 }
box { <0, -0.3, -200>, <7, 0, 200> pigment { Asphalt } }
#for (I, -30, 30)
    box { <3.44, 0, 6*I>, <3.56, 0.003, 6*I + 3> pigment { rgb 0.65 } }
#end
#for (I, 0, 1)
    #local Edge = 7*I - 0.15*(1 - I);
    box { <Edge, -0.3, -200>, <Edge + 0.15, 0.12, 200> pigment { rgb 0.42 } }
    box { <(I ? 7.15 : -2.65), -0.3, -200>, <(I ? 9.65 : -0.15), 0.11, 200> pigment { Stone } }
#end

#declare Stream = seed(23);
#macro Window(Lit)
    box { <0, 0, -0.02>, <1.1, 1.6, 0.03> pigment { rgb 0.7 } }
    #if (Lit)
        box { <0.06, 0.06, -0.03>, <1.04, 1.54, 0> pigment { rgb kelvin(2500 + 900*rand(Stream)) }
            finish { diffuse 0 emission nit(8 + 20*rand(Stream)) no_luminaire } }
    #else
        box { <0.06, 0.06, -0.03>, <1.04, 1.54, 0> pigment { rgb 0.02 } finish { diffuse 1 reflection 0.06 } }
    #end
#end
// A front along x, from 0 to Wide, which faces -z.
#macro House(Wide, Floors)
    union {
        #local Tone = <0.5 + 0.25*rand(Stream), 0.42 + 0.2*rand(Stream), 0.34 + 0.2*rand(Stream)>;
        box { <0, 0, 0>, <Wide, 3.1*Floors + 0.6, 9> pigment { rgb Tone } }
        box { <-0.1, 3.1*Floors + 0.4, -0.25>, <Wide + 0.1, 3.1*Floors + 0.75, 9> pigment { rgb 0.3 } }
        box { <0, 0, -0.06>, <Wide, 0.7, 0> pigment { rgb Tone*0.6 } }
        #local Row = int(Wide/2.4);
        #for (K, 0, Floors - 1)
            #for (I, 0, Row - 1)
                #if (K = 0 & I = int(Row/2))
                    box { <0, 0, -0.04>, <1.1, 2.3, 0.02> translate (I + 0.25)*Wide/Row*x pigment { rgb <0.15, 0.1, 0.07> } }
                #else
                    union { Window((rand(Stream) < 0.28)) translate <(I + 0.25)*Wide/Row, 3.1*K + 1, 0> }
                #end
            #end
        #end
    }
#end
#declare Far = -70;
#while (Far < 150)
    #local Wide = 8 + 5*rand(Stream);
    object { House(Wide - 0.05, 2 + int(2.6*rand(Stream))) rotate 90*y translate <9.65, 0, Far + Wide> }
    object { House(Wide - 0.05, 2 + int(2.6*rand(Stream))) rotate -90*y translate <-2.65, 0, Far> }
    #declare Far = Far + Wide;
#end

// ---- parked cars, a post box, a bench
#macro Car(Paint)
    union {
        superellipsoid { <0.25, 0.25> scale <0.85, 0.32, 2.05> translate 0.62*y
            pigment { rgb Paint } finish { diffuse 0.8 specular 0.5 roughness 0.01 reflection { 0.02, 0.3 fresnel on } } interior { ior 1.5 } }
        superellipsoid { <0.35, 0.35> scale <0.72, 0.3, 1.1> translate <0, 1.12, -0.2>
            pigment { rgb 0.02 } finish { diffuse 1 specular 0.6 roughness 0.005 reflection { 0.03, 0.5 fresnel on } } interior { ior 1.5 } }
        superellipsoid { <0.4, 0.4> scale <0.62, 0.05, 0.85> translate <0, 1.41, -0.2> pigment { rgb Paint } }
        #for (I, 0, 3)
            cylinder { -0.1*x, 0.1*x, 0.31 translate <(mod(I, 2) - 0.5)*1.5, 0.31, (int(I/2) - 0.5)*2.5> pigment { rgb 0.02 } }
            cylinder { -0.11*x, 0.11*x, 0.17 translate <(mod(I, 2) - 0.5)*1.5, 0.31, (int(I/2) - 0.5)*2.5> pigment { rgb 0.45 } }
        #end
        #for (I, -1, 1, 2)
            box { <-0.16, -0.06, -0.01>, <0.16, 0.06, 0.01> translate <0.55*I, 0.68, -2.05> pigment { rgb <0.4, 0.02, 0.02> } }
        #end
    }
#end
object { Car(<0.35, 0.04, 0.03>) translate <0.95, 0, -9> }
object { Car(<0.3, 0.34, 0.4>) translate <0.95, 0, -3> }
object { Car(<0.05, 0.08, 0.16>) translate <0.95, 0, 33> }
object { Car(<0.6, 0.6, 0.58>) translate <0.95, 0, 41> }

// ---- the lamps, over the right edge
#for (I, -3, 5)
    object { Luminaire_Street(8, 0.9, 9000, 3000) rotate 180*y translate <7.75, 0.1, 30*I> }
#end

// ---- what is measured: the field between the lamps at z = 0 and z = 30, seen from 60 metres before it
meter { "lane 1" luminance eye <1.75, 1.5, -60> corner <0, 0.001, 0> along 30*z across 3.5*x en_13201 }
meter { "lane 2" luminance eye <5.25, 1.5, -60> corner <3.5, 0.001, 0> along 30*z across 3.5*x en_13201 }
meter { "road" corner <0, 0.01, 0> along 30*z across 7*x en_13201 direction y }
meter { "pavement" corner <7.15, 0.12, 0> along 30*z across 2.5*x en_13201 direction y }
meter { "driver" threshold_increment road "lane 2" points { 1, <5.25, 1.5, -20> } direction <0, -sin(pi/180), cos(pi/180)> }
