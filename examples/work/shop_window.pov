// SPDX-License-Identifier: CC0-1.0
// A shop window at dusk: spots of 2000 lm on a track over what is shown, a strip of LEDs behind the frame, panels in the
// shop, and the lamp of the street. The meters tell the light on the goods, the ratio of accent to surroundings, and what
// falls on the pavement.
//   candelabra shop_window.pov --measure shop_window.csv
//   candelabra shop_window.pov +Oshop.exr --layers illuminance,luminance
//   candelabra develop shop.exr --false-colour lux --isolines -o shop_lux.png
#version 3.7;
#include "luminaires.inc"
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 150 }
    integrator { path_traced bounces 5 }
    max_trace_level 8
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location <-1.7, 1.6, -5.2>
    right 3/2*x up y angle 58
    look_at <0.1, 1.5, 0>
    film { exposure auto response agx }
}
// The sky ten minutes after sunset.
sky_luminance { clear sun <-4, 300> north z }

#declare Stream = seed(17);

// ---- the pavement and the front
#for (I, -9, 9)
    #for (K, -12, 0)
        box { <0.6*I + 0.004, -0.1, 0.4*K + 0.004>, <0.6*I + 0.596, 0, 0.4*K + 0.396> translate <0.3*mod(K + 12, 2), 0, 0>
            pigment { rgb 0.2 + 0.12*rand(Stream) } }
    #end
#end
plane { y, -0.01 pigment { rgb 0.1 } }
#declare Front = texture { pigment { rgb <0.045, 0.09, 0.075> } finish { specular 0.2 roughness 0.03 } }
#declare Brick = texture { pigment { brick rgb 0.5, rgb <0.36, 0.13, 0.09> brick_size <0.25, 0.08, 0.12> mortar 0.01 } }
box { <-6, 0, 0>, <-2.2, 6, 0.35> texture { Brick } }
box { <3.4, 0, 0>, <7, 6, 0.35> texture { Brick } }
box { <-2.2, 3.2, 0>, <3.4, 6, 0.35> texture { Brick } }
union {
    box { <-2.2, 0, -0.05>, <2.05, 0.5, 0.3> }
    box { <-2.2, 2.62, -0.08>, <3.4, 3.2, 0.3> }
    box { <-2.2, 0, -0.05>, <-2.08, 2.7, 0.3> }
    box { <1.93, 0, -0.05>, <2.05, 2.7, 0.3> }
    box { <3.3, 0, -0.05>, <3.4, 2.7, 0.3> }
    box { <-0.03, 0.5, 0>, <0.03, 2.62, 0.06> }
    box { <-2.3, 3.15, -0.2>, <3.5, 3.25, 0.3> }
    texture { Front }
}
text { ttf "timrom.ttf" "B O O K S" 0.03, 0 scale 0.34 translate <-1.05, 2.78, -0.115>
    pigment { rgb <0.75, 0.6, 0.3> } finish { specular 0.4 } }
// the pane
box { <-2.08, 0.5, 0.02>, <1.93, 2.62, 0.03> pigment { rgbt <0.97, 0.99, 0.98, 0.96> }
    finish { diffuse 0 reflection { 0.02, 0.8 fresnel on } conserve_energy } interior { ior 1.5 } }
// the door, with a pane
union {
    box { <2.05, 0, 0.05>, <2.17, 2.62, 0.11> } box { <3.18, 0, 0.05>, <3.3, 2.62, 0.11> }
    box { <2.05, 0, 0.05>, <3.3, 0.35, 0.11> } box { <2.05, 2.3, 0.05>, <3.3, 2.62, 0.11> }
    cylinder { <2.27, 0.95, -0.01>, <2.27, 1.25, -0.01>, 0.015 pigment { rgb <0.7, 0.55, 0.25> } finish { specular 0.6 } }
    texture { Front }
}
box { <2.17, 0.35, 0.07>, <3.18, 2.3, 0.08> pigment { rgbt <0.97, 0.99, 0.98, 0.96> }
    finish { diffuse 0 reflection { 0.02, 0.8 fresnel on } conserve_energy } interior { ior 1.5 } }

// ---- the window: a floor, a back of half height, the shop behind
box { <-2.1, 0.4, 0.1>, <1.95, 0.5, 1.5> pigment { rgb <0.5, 0.36, 0.22> } }
box { <-2.1, 0.5, 1.45>, <1.95, 1.25, 1.5> pigment { rgb <0.55, 0.5, 0.42> } }
box { <-2.2, 2.75, 0>, <3.4, 2.85, 7> pigment { rgb 0.8 } }
box { <-2.25, 0, 0.3>, <-2.15, 2.8, 7> pigment { rgb <0.6, 0.5, 0.38> } }
box { <3.35, 0, 0.3>, <3.45, 2.8, 7> pigment { rgb <0.6, 0.5, 0.38> } }
box { <-2.2, 0, 6.9>, <3.4, 2.8, 7> pigment { rgb <0.6, 0.5, 0.38> } }
box { <-2.2, -0.05, 0.3>, <3.4, 0.005, 7> pigment { rgb <0.3, 0.2, 0.13> } }
#macro Book(High, Deep, Thick)
    union {
        #local Cover = <0.12 + 0.6*rand(Stream), 0.1 + 0.4*rand(Stream), 0.1 + 0.4*rand(Stream)>;
        box { 0, <Thick, High, 0.004> } box { 0, <0.004, High, Deep> } box { <Thick - 0.004, 0, 0>, <Thick, High, Deep> }
        box { <0.005, 0.004, 0.004>, <Thick - 0.005, High - 0.004, Deep - 0.004> pigment { rgb 0.82 } }
        box { <Thick*0.3, High*0.65, -0.001>, <Thick*0.7, High*0.85, 0> pigment { rgb 0.75 } }
        pigment { rgb Cover } finish { specular 0.15 roughness 0.04 }
    }
#end
// shelves along the walls of the shop
#macro Shelf(Wide)
    union {
        #for (K, 0, 5)
            box { <0, 0.42*K, 0>, <Wide, 0.42*K + 0.025, 0.28> pigment { rgb <0.35, 0.22, 0.13> } }
            #local Far = 0.03;
            #while (Far < Wide - 0.06)
                #local Thick = 0.018 + 0.035*rand(Stream);
                object { Book(0.2 + 0.14*rand(Stream), 0.2, Thick) translate <Far, 0.42*K + 0.025, 0.03> }
                #local Far = Far + Thick + 0.002 + (rand(Stream) < 0.05 ? 0.1 : 0);
            #end
        #end
    }
#end
object { Shelf(5.4) translate <-2.1, 0.05, 6.6> }
object { Shelf(4.8) rotate -90*y translate <-1.85, 0.05, 1.8> }
object { Shelf(4.8) rotate 90*y translate <3.05, 0.05, 6.6> }
box { <-0.8, 0.005, 3.4>, <1.6, 0.8, 4.4> pigment { rgb <0.4, 0.27, 0.16> } }
#for (I, 0, 11)
    union { object { Book(0.3, 0.22, 0.05) rotate -90*z } translate <-0.7 + 0.36*mod(I, 6), 0.86 + 0.05*(I > 5), 3.5 + 0.3*mod(I, 3)> }
#end

// what is shown: stands with books, piles, a globe and a plant
#macro Stand(At, Turn)
    union {
        object { Book(0.3, 0.2, 0.035) rotate -90*y translate <0.1, 0, 0> rotate 14*x translate 0.02*y }
        box { <-0.11, 0, 0.02>, <0.11, 0.02, 0.16> pigment { rgb 0.05 } }
        rotate Turn*y translate At
    }
#end
#declare Plinth = texture { pigment { rgb 0.78 } }
box { <-1.75, 0.5, 0.55>, <-1.05, 0.9, 1.15> texture { Plinth } }
box { <-0.45, 0.5, 0.5>, <0.35, 0.72, 1.1> texture { Plinth } }
box { <0.95, 0.5, 0.55>, <1.6, 1.05, 1.15> texture { Plinth } }
Stand(<-1.55, 0.9, 0.75>, 12) Stand(<-1.22, 0.9, 0.85>, -8)
Stand(<-0.25, 0.72, 0.8>, 6) Stand(<0.12, 0.72, 0.75>, -10)
Stand(<1.12, 1.05, 0.8>, 9) Stand(<1.43, 1.05, 0.8>, -12)
#for (I, 0, 7)
    union { object { Book(0.26 - 0.01*mod(I, 4), 0.19, 0.036) rotate -90*z }
        translate <-0.95 + 0.02*mod(I*3, 4), 0.538 + 0.037*mod(I, 4), 0.45 + 0.03*mod(I, 2)> translate (I > 3)*1.37*x }
#end
// a globe
union {
    sphere { 0, 0.17 pigment { bozo turbulence 0.5 color_map { [0.5 rgb <0.12, 0.25, 0.4>] [0.5 rgb <0.5, 0.42, 0.22>] [1 rgb <0.3, 0.36, 0.16>] } scale 0.13 } finish { specular 0.3 roughness 0.02 } }
    torus { 0.19, 0.008 rotate 90*x rotate 23*z pigment { rgb <0.6, 0.45, 0.2> } finish { specular 0.6 } }
    cone { -0.33*y, 0.09, -0.19*y, 0.015 pigment { rgb <0.25, 0.15, 0.08> } }
    translate <-0.05, 1.6, 1.2>
}
box { <-0.3, 0.72, 1.05>, <0.2, 1.27, 1.42> texture { Plinth } }

// ---- the lamps
cylinder { <-2.05, 2.72, 0.35>, <1.9, 2.72, 0.35>, 0.02 texture { Luminaire_Metal } }
#macro Spot_At(From, To)
    #local Way = To - From;
    object { Luminaire_Spot(2000, 3000) rotate -degrees(atan2(vlength(<Way.x, 0, Way.z>), -Way.y))*x
        rotate degrees(atan2(Way.x, Way.z))*y translate From }
#end
Spot_At(<-1.4, 2.7, 0.35>, <-1.4, 1, 0.85>)
Spot_At(<-0.3, 2.7, 0.35>, <-0.1, 0.8, 0.8>)
Spot_At(<0.3, 2.7, 0.35>, <-0.05, 1.6, 1.2>)
Spot_At(<1.2, 2.7, 0.35>, <1.28, 1.1, 0.85>)
object { Luminaire_Strip(<-2.05, 0.53, 0.11>, <1.9, 0.53, 0.11>, 400, 2700) }
box { <-2.08, 0.5, 0.04>, <1.93, 0.56, 0.1> texture { Front } }
#for (I, 0, 2)
    object { Luminaire_Panel(1.2, 0.3, 3000, 3000) translate <0.6, 2.745, 2.3 + 1.6*I> }
#end
object { Luminaire_Street(5.5, 0.8, 6000, 3000) rotate 160*y translate <5.2, 0, -3.4> }

// ---- what is measured
meter { "goods" corner <-1.9, 1.15, 0.45> along 3.7*x counts <12, 1> direction <0, 1, -1> }
meter { "shop" corner <-1.5, 0.85, 1.8> along 4*x across 1.4*z counts <5, 3> direction y }
meter { "pavement" corner <-2.2, 0.01, -2.5> along 4.2*x across 2.3*z counts <6, 4> direction y }
