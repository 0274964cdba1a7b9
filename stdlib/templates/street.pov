// SPDX-License-Identifier: CC0-1.0
// A street at night, with as many lamps as you like.
//   candelabra street.pov +W1280 +H720
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0.7 } }

#declare Lamps = 40;     // on each side
#declare Distance = 12;  // between two of them

camera {
    location <-1.4, 1.7, -8> look_at <0.4, 2.6, 30> angle 60
    right x*image_width/image_height  // the shape of the picture
    film {
        exposure 2             // in stops
        response agx           // how bright light fades into white
        vignette 0.25
        glare { veil 0.08 halo 0.004 star 0.02 blades 6 }
    }
}
background { rgb <0.004, 0.006, 0.014> }
fog { distance 260 rgb <0.006, 0.008, 0.014> }

// Wet asphalt, pavements, and houses with lit windows.
plane { y, 0
    pigment { rgb 0.06 }
    normal { bumps 0.06 scale <0.6, 1, 2> }
    finish { microfacet { roughness 0.3 } }
}
#for (Side, -1, 1, 2)
    box { <4.2, 0, -20>, <7, 0.15, 520> scale <Side, 1, 1> pigment { rgb 0.25 } }
#end

#declare Seed = seed(7);
#for (Side, -1, 1, 2)
    #for (House, 0, 39)
        #local Height = 7 + 9*rand(Seed);
        #local Near = Distance*House - 15;
        box { <7, 0, Near>, <15, Height, Near + Distance - 0.4>
            scale <Side, 1, 1>
            pigment { rgb <0.3, 0.26, 0.22>*(0.5 + rand(Seed)) }
        }
        #for (Floor, 1, Height/3 - 1)
            #for (Window, 0, 3)
                #if (rand(Seed) < 0.3)
                    box { <6.97, 3*Floor, Near + 1.2 + 2.6*Window>, <6.99, 3*Floor + 1.6, Near + 2.4 + 2.6*Window>
                        scale <Side, 1, 1>
                        pigment { rgb 1 }
                        finish { diffuse 0 emission <1, 0.6 + 0.3*rand(Seed), 0.3 + 0.3*rand(Seed)>*(0.3 + 0.8*rand(Seed)) }
                    }
                #end
            #end
        #end
    #end
#end

// The lamps: a mast, an arm, and a ball that glows.
#for (Side, -1, 1, 2)
    #for (I, 0, Lamps - 1)
        union {
            cylinder { <4.6, 0, 0>, <4.6, 5.6, 0>, 0.06 }
            cylinder { <4.6, 5.6, 0>, <3.6, 5.7, 0>, 0.04 }
            pigment { rgb 0.08 }
            scale <Side, 1, 1> translate Distance*I*z
        }
        sphere { <3.5*Side, 5.55, Distance*I>, 0.16
            pigment { rgb 1 }
            finish { diffuse 0 emission <1, 0.6, 0.26>*90 }
        }
    #end
#end
