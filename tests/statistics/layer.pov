// SPDX-License-Identifier: GPL-3.0-or-later
// A square layer of Across by Across small lamps, 1 above a white floor, whose light is a sum in a formula: a lamp of radius r
// and radiance L, d away and 1 above, gives the floor a colour of L r^2 / d^3.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Across) #declare Across = 400; #end
#declare Step = 32/Across;
camera { orthographic location 0.5*y look_at 0 right 0.2*x up 0.2*z }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#ifndef (Placed) #declare Placed = 0; #end
#declare Lamp = sphere { 0, Step/20 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 100 } }
#if (Placed)
    // The same lamps by squares of 20 by 20 of them.
    #declare Square = union {
        #for (I, 0, 19) #for (K, 0, 19) object { Lamp translate <I - 9.5, 0, K - 9.5>*Step } #end #end
    }
    #declare Squares = Across/20;
    #for (I, 0, Squares - 1)
        #for (K, 0, Squares - 1)
            object { Square translate <(I - (Squares - 1)/2)*20*Step, 1, (K - (Squares - 1)/2)*20*Step> }
        #end
    #end
#else
    #for (I, 0, Across - 1)
        #for (K, 0, Across - 1)
            sphere {
                <(I - (Across - 1)/2)*Step, 1, (K - (Across - 1)/2)*Step>, Step/20
                pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 100 }
            }
        #end
    #end
#end
