// SPDX-License-Identifier: CC0-1.0
// A city from the air: some 34,000 lit windows and 3000 street lamps, each of which lights the
// streets and the houses opposite. Declare=Blocks=... makes it bigger; with Declare=Lit=0.01 one
// window and one lamp in a hundred are lit.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }
background { rgb <0.006, 0.009, 0.022> }

#ifndef (Blocks) #declare Blocks = 22; #end
#ifndef (Lit) #declare Lit = 1; #end

camera {
    location <-6, 19, -50>
    right 16/9*x
    up y
    angle 46
    look_at <2, 6, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Pitch = 5;
#declare Random = seed(2026);
#declare Chance = seed(7);
#declare Dark = texture { pigment { rgb 0.1 } finish { Matt } }

// A window in the plane z = 0, facing -z, in four kinds of light
#declare Windows = array[4];
#declare Lights = array[4] { <1, 0.5, 0.18>, <1, 0.62, 0.3>, <1, 0.38, 0.1>, <0.5, 0.7, 1> }
#for (I, 0, 3)
    #declare Windows[I] = box {
        <-0.11, -0.16, -0.015>, <0.11, 0.16, 0.015>
        pigment { rgb Lights[I] }
        finish { ambient 0 diffuse 0 emission 3.5 }
    }
#end

// The lit windows of one side of a house, Across by Up, at the distance Away from its middle
#macro Side(Across, Up, Share, Away, Turn)
    #for (Row, 0, Up - 1)
        #for (Column, 0, Across - 1)
            #if (rand(Random) < Share)
                object {
                    Windows[int(3.3*rand(Random))]
                    #if (rand(Chance) >= Lit) texture { Dark } #end
                    translate <(Column - (Across - 1)/2)*0.42, 0.5 + 0.55*Row, -Away>
                    rotate Turn*y
                }
            #end
        #end
    #end
#end

// The nearer the middle, the higher
#for (I, 0, Blocks - 1)
    #for (J, 0, Blocks - 1)
        #declare Place = <I - (Blocks - 1)/2, 0, J - (Blocks - 1)/2>;
        #declare Rise = 30*exp(-vdot(Place, Place)/26);
        #declare Floors = 4 + int(5*rand(Random) + Rise*pow(rand(Random), 2));
        #declare Wide = 5 + int(4*rand(Random));
        #declare Deep = 5 + int(4*rand(Random));
        #declare Share = 0.15 + 0.4*rand(Random);
        #declare X = 0.21*Wide + 0.1;
        #declare Z = 0.21*Deep + 0.1;
        union {
            box {
                <-X, 0, -Z>, <X, 0.55*Floors + 0.5, Z>
                pigment { rgb 0.3 + 0.2*rand(Random)*<1, 0.9, 0.8> }
                finish { Matt }
            }
            Side(Wide, Floors, Share, Z, 0)
            Side(Wide, Floors, Share, Z, 180)
            Side(Deep, Floors, Share, X, 90)
            Side(Deep, Floors, Share, X, -90)
            translate Pitch*Place
        }
    #end
#end

#declare Lamp = sphere {
    <0, 0.6, 0>, 0.05
    pigment { rgb <1, 0.6, 0.22> }
    finish { ambient 0 diffuse 0 emission 60 }
}
#for (I, 0, Blocks)
    #declare Where = (I - Blocks/2)*Pitch;
    #if (Lit = 1)
        object { Light_Grid(Lamp, <Blocks*3, 1, 1>, <Pitch/3, 0, 0>) translate Where*z }
        object { Light_Grid(Lamp, <1, 1, Blocks*3>, <0, 0, Pitch/3>) translate Where*x }
    #else
        #for (J, 0, 6*Blocks - 1)
            #declare Along = (mod(J, 3*Blocks) - (3*Blocks - 1)/2)*Pitch/3;
            object {
                Lamp
                #if (rand(Chance) >= Lit) texture { Dark } #end
                translate (J < 3*Blocks ? <Along, 0, Where> : <Where, 0, Along>)
            }
        #end
    #end
#end
plane { y, 0 pigment { rgb 0.25 } finish { Matt } }
