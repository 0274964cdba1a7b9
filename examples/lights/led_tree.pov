// SPDX-License-Identifier: CC0-1.0
// Light_Frames: a tree of 500 LEDs, whose places and colours are in two tables: led_tree_coords.csv
// and led_tree_frames.csv, 100 frames, both written by led_tree.py. The film, four seconds that begin
// anew without a jump:
//
//   candelabra led_tree.pov +KFI0 +KFF99 +W320 +H240 --movie led_tree.mp4
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <0, 1.15, -4.6>
    right 4/3*x
    up y
    angle 38
    look_at <0, 1.12, 0>
}

#declare Led = sphere { <0, 0, 0>, 0.016 }
object { Light_Frames(Led, "led_tree_coords.csv", "led_tree_frames.csv", frame_number, 9) }

// The fir: whorls of boughs, on which twigs stand to both sides.
#declare Needles = texture { pigment { rgb <0.1, 0.3, 0.13> } finish { ambient 0 diffuse 1 } }
#declare Bark = texture { pigment { rgb <0.2, 0.13, 0.09> } finish { ambient 0 diffuse 1 } }
#declare Chance = seed(3);
cone { <0, 0, 0>, 0.06, <0, 2.2, 0>, 0.008 texture { Bark } }
#macro Bough(Length)
    union {
        #local Twigs = int(9 + 22*Length);
        cylinder { <0, 0, 0>, Length*<1, -0.18, 0>, 0.006 texture { Bark } }
        #for (I, 1, Twigs)
            #local Part = I/Twigs;
            #local Size = 0.05 + 0.13*Length*(1 - Part);
            #for (Side, -1, 1, 2)
                cone {
                    <0, 0, 0>, 0.012, Size*<0.75, 0.1 + 0.3*rand(Chance), 0.8*Side>, 0.003
                    translate Part*Length*<1, -0.18, 0>
                }
            #end
        #end
        texture { Needles }
    }
#end
#for (Whorl, 0, 25)
    #declare Share = Whorl/26;
    #declare Boughs = int(15 - 8*Share);
    #for (I, 0, Boughs - 1)
        object {
            Bough((0.8*(1 - Share) + 0.03)*(0.85 + 0.2*rand(Chance)))
            rotate 12*(rand(Chance) - 0.3)*z
            rotate (360*(I + 0.5*rand(Chance))/Boughs + 47*Whorl)*y
            translate (0.33 + 1.87*Share)*y
        }
    #end
#end

// Snow, a few presents' worth of spheres to mirror the tree, and the night.
plane { y, 0 pigment { rgb 0.8 } normal { bumps 0.12 scale 0.3 } finish { ambient 0 diffuse 1 } }
#for (I, 0, 10)
    sphere {
        <0, 0.07 + 0.05*mod(I, 3), 0>, 0.07 + 0.05*mod(I, 3)
        pigment { rgb <0.7, 0.7, 0.72> }
        finish { ambient 0 diffuse 0.5 reflection 0.35 }
        translate (0.95 + 0.35*rand(Chance))*x
        rotate (180 + 18*I)*y
    }
#end
light_source { <-30, 60, -40>, rgb <0.012, 0.016, 0.03> parallel point_at 0 }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <0.004, 0.006, 0.012>] [0.6 rgb 0.001] } }
    pigment {
        bozo scale 0.006
        color_map { [0.9 rgbt 1] [0.93 rgb <0.25, 0.26, 0.3>] [1 rgb <0.7, 0.7, 0.8>] }
    }
}
