// SPDX-License-Identifier: GPL-3.0-or-later
// A room with lamps, and a sun outside that is a million times brighter, behind closed shutters.
// Declare=Sun=0 takes it away; Declare=Gap=0.1 opens a hole of that radius in the roof.
#version 3.7;
#ifndef (Sun) #declare Sun = 1; #end
#ifndef (Gap) #declare Gap = 0; #end
global_settings { assumed_gamma 1 }
camera { location <-1.7, 1.6, -2.7> look_at <0.4, 0.7, 0.5> right x up y angle 75 }
#declare Matt = texture { pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } }
difference {
    box { <-2.2, -0.2, -3.2>, <2.2, 2.6, 3.2> }
    box { <-2, 0, -3>, <2, 2.4, 3> }
    #if (Gap)
        cylinder { <0.5, 2.5, 0.2> - 0.5*vnormalize(<59.5, 77.5, 29.8>), <0.5, 2.5, 0.2> + 0.5*vnormalize(<59.5, 77.5, 29.8>), Gap }
    #end
    texture { Matt }
}
box { <-0.6, 0, 0>, <0.6, 0.7, 1.2> texture { Matt } }
#for (I, 0, 39)
    sphere { <-1.8 + 0.4*mod(I, 10), 2.2, -2 + 1.3*div(I, 10)>, 0.05 pigment { rgb <1, 0.8, 0.6> } finish { emission 6 diffuse 0 } }
#end
#if (Sun)
    sphere { <60, 80, 30>, 4 pigment { rgb 1 } finish { emission 6e6 diffuse 0 } }
#end
