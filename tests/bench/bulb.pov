// SPDX-License-Identifier: GPL-3.0-or-later
// A bulb of many patches that reflect nothing and glow: the paper's imposters, each a luminaire of
// its own. Declare=Across=... patches around it, half as many from pole to pole, two triangles
// each.
#version 3.7;
#ifndef (Across) #declare Across = 14; #end
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.6, 0> right x up y angle 50 }
plane { y, 0 pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }
box { <-1.4, 0, -0.3>, <-1.1, 1.2, 0.3> pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }
#declare Up = int(Across/2);
#macro At(I, J) #local H = pi*J/Up; #local T = 2*pi*I/Across;
    <sin(H)*cos(T), cos(H), sin(H)*sin(T)>*0.5 + 1.5*y
#end
#declare Patch = texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 5 } }
#for (I, 0, Across - 1)
    #for (J, 0, Up - 1)
        #if (J > 0) triangle { At(I, J), At(I + 1, J), At(I, J + 1) texture { Patch } } #end
        #if (J < Up - 1) triangle { At(I + 1, J), At(I, J + 1), At(I + 1, J + 1) texture { Patch } } #end
    #end
#end
