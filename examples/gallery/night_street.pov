// SPDX-License-Identifier: CC0-1.0
// A street in the rain: lit windows, signs, street lamps, strings of bulbs from house to house and
// the lights of cars, a thousand luminaires in thin haze, all of them again in the wet road.
#version 3.7;
#include "light_arrays.inc"
#include "people.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.004, 0.007, 0.016> }

camera {
    location <-0.6, 1.25, -11.5>
    right 16/9*x
    up y
    angle 52
    look_at <-0.1, 2.75, 10>
    film {
        exposure 0.3
        response agx
        vignette 0.3
        glare { veil 0.17 halo 0.004 star 0.02 blades 6 angle 12 length 0.4 }
    }
}
fog { rgb <0.05, 0.036, 0.03> distance 55 }

#declare Matt = finish { ambient 0 diffuse 0.9 }
#declare Iron = texture { pigment { rgb 0.03 } finish { Matt specular 0.3 roughness 0.03 } }
#macro Glow(Colour, Radiance)
    texture { pigment { rgb Colour } finish { ambient 0 diffuse 0 emission Radiance } }
#end

// A window with somebody's light behind its bars: uneven, as curtains and shelves make it
#macro Lit(Colour, Radiance)
    texture {
        pigment {
            brick
            pigment { rgb 0.01 }
            pigment {
                bozo
                scale <0.3, 0.5, 0.3>
                color_map { [0.25 rgb Colour*0.25] [0.7 rgb Colour] }
            }
            brick_size <0.43, 0.6, 40> mortar 0.045 translate <0.02, 0.02, -10>
        }
        finish { ambient 0 diffuse 0 emission Radiance }
    }
#end

// A house with its front to -z: windows, a shop with an awning below, a sign that stands out
#declare Pane = box { <-0.38, 0, -0.04>, <0.38, 1.15, 0.1> }
#declare Dark = object { Pane pigment { rgb 0.02 } finish { Matt reflection 0.12 } }
#declare Shop = box { <-0.85, 0, -0.04>, <0.85, 1.7, 0.1> }
#declare Shut = object { Shop pigment { rgb 0.03 } finish { Matt } }
#macro House(Wall, Lamp, Sign, Floors, Seed)
    union {
        box { <-3, 0, 0>, <3, 3.1 + 1.9*Floors, 6> }
        box { <-3.05, 3 + 1.9*Floors, -0.25>, <3.05, 3.2 + 1.9*Floors, 0.2> }
        object {
            Light_Facade(object { Pane Lit(Lamp, 1.2) }, Dark, <4, Floors>, <1.4, 1.9>, 0.42, Seed)
            translate 3.3*y
        }
        object {
            Light_Facade(object {
                Shop Lit(<1, 0.42, 0.13>, 2.2)
            }, Shut, <3, 1>, <1.95, 1>, 0.7, Seed + 50)
            translate 0.5*y
        }
        box { <-2.9, 2.35, -0.9>, <2.9, 2.42, 0> pigment { rgb <0.4, 0.08, 0.06> } }
        box { <2, 3.6, -0.85>, <2.08, 5.4, -0.3> Glow(Sign, 3) }
        difference {
            box { <1.96, 3.52, -0.93>, <2.12, 5.48, -0.22> }
            box { <1.9, 3.6, -0.85>, <2.2, 5.4, -0.3> }
        }
        pigment { rgb Wall }
        finish { Matt }
    }
#end
#declare Signs = array[5] {
    <1, 0.05, 0.12>, <0.05, 0.6, 1>, <1, 0.35, 0.03>, <0.1, 1, 0.4>, <0.8, 0.08, 1>
}
#declare Random = seed(12);
#for (I, 0, 9)
    #for (Side, -1, 1, 2)
        #declare Wall = <0.3 + 0.15*rand(Random), 0.22 + 0.1*rand(Random), 0.18 + 0.1*rand(Random)>;
        object {
            House(
                Wall, <1, 0.42 + 0.3*rand(Random), 0.12 + 0.3*rand(Random)>,
                Signs[mod(2*I + (Side + 1)/2, 5)], 3 + int(3*rand(Random)), I + 10*Side
            )
            rotate 90*Side*y
            translate <6*Side, 0, -6 + 6.2*I>
        }
    #end
#end

// Street lamps, and strings of bulbs across
#declare Lamp = union {
    cylinder { <0, 0, 0>, <0, 3.6, 0>, 0.05 texture { Iron } }
    cylinder { <0, 3.6, 0>, <0.7, 3.75, 0>, 0.03 texture { Iron } }
    cone { <0.7, 3.66, 0>, 0.22, <0.7, 3.88, 0>, 0.03 texture { Iron } }
    sphere { <0.7, 3.62, 0>, 0.11 Glow(<1, 0.55, 0.2>, 90) }
}
object { Light_Street(Lamp, 9, 6.2, 8) translate -2.9*z }
#for (I, 0, 13)
    #declare Hooks = array[2] { <-6, 5.6, 4*I - 1>, <6, 5.6 + 0.5*sin(3*I), 4*I + 0.5> }
    object {
        Light_String(sphere { <0, -0.05, 0>, 0.034 Glow(<1, 0.55, 0.2>, 16) }, 56, Hooks, 0.09)
    }
#end

// The wet road, its kerbs, and cars
#declare Wet = finish { ambient 0 microfacet { roughness 0.16 specular 0.9 } }
plane { y, 0 pigment { rgb 0.025 } normal { bumps 0.12 scale <0.35, 1, 0.9> } finish { Wet } }
box {
    <-6, 0, -20>, <-3.7, 0.12, 80>
    pigment { rgb 0.1 }
    normal { bumps 0.1 scale 0.3 }
    finish { Wet }
}
box {
    <3.7, 0, -20>, <6, 0.12, 80>
    pigment { rgb 0.1 }
    normal { bumps 0.1 scale 0.3 }
    finish { Wet }
}
#for (I, 0, 5)
    #declare Way = mod(I, 2)*2 - 1;
    union {
        box { <-0.75, 0.3, -1.7>, <0.75, 0.8, 1.7> }
        box { <-0.62, 0.8, -1>, <0.62, 1.3, 0.9> }
        #for (Side, -1, 1, 2)
            sphere {
                <0.55*Side, 0.6, -1.7>,
                0.1 Glow((Way > 0 ? <1, 0.03, 0.02> : <1, 0.85, 0.6>), (Way > 0 ? 14 : 60))
            }
        #end
        pigment { rgb 0.1 + 0.2*<rand(Random), rand(Random), rand(Random)> }
        finish { Matt specular 0.5 roughness 0.01 reflection 0.1 }
        translate <1.9*Way, 0, 6 + 6.5*I>
    }
#end

// Somebody walks home under a red umbrella
union {
    Person(Fedora, Pale, rgb 0.03, rgb 0.03, Black, 0.46, <-0.29, 0.86, 0.1>, <0.14, 1.2, -0.22>,
           0.17, 0)
    union {
        Umbrella(rgb <0.8, 0.03, 0.03>)
        scale <1.15, 1.1, 1.15>
        rotate <4, 12, 3>
        translate <0.1, 1.84, -0.2>
    }
    rotate 176*y
    translate <-0.95, 0, -3.4>
}

// The rain
#for (I, 1, 1800)
    #declare Far = 1 + 14*pow(rand(Random), 1.5);
    #declare Drop = <
        (rand(Random) - 0.5)*1.2*Far, 1.25 + (rand(Random) - 0.3)*0.75*Far, Far - 11.5
    >;
    cylinder {
        Drop, Drop + <0.03, 0.28, 0>, 0.0013
        open no_shadow
        pigment { rgbt <0.9, 0.95, 1, 0.75> }
        finish { Matt emission 0.05 no_luminaire }
    }
#end
