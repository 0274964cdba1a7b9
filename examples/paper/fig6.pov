// SPDX-License-Identifier: CC0-1.0
// Shirley and Wang, "Luminaire Sampling in Distribution Ray Tracing", Figure 6: 7381 diffuse
// spheres beside 7381 luminaires over a plane; all light comes from the right flake, and its power
// is the same for every number of luminaires:
//   Declare=Luminaires=1        only its biggest sphere glows, the others are diffuse
//   Declare=Depth=5             66430 luminaires: the right flake is a level deeper
//   Declare=Reflecting_Depth=3  the left flake's depth, 4 if not said
#version 3.7;
#include "sphereflake.inc"
global_settings { assumed_gamma 1.0 }

#ifndef (Depth) #declare Depth = 4; #end
#ifndef (Reflecting_Depth) #declare Reflecting_Depth = 4; #end
#ifndef (Luminaires) #declare Luminaires = Sphereflake_Count(Depth); #end

#if (Luminaires != 1 & Luminaires != Sphereflake_Count(Depth))
    #error concat("Luminaires must be 1, or ", str(Sphereflake_Count(Depth), 0, 0),
                  " for all of depth ", str(Depth, 0, 0),
                  ", but it is ", str(Luminaires, 0, 0), "\n")
#end

// z is up and +x on the right: the minus makes the system right-handed.
camera {
    location <0, -10, 7>
    sky z
    right -x
    up y
    angle 42
    look_at <0, 0, 0.7>
}

#declare Matt = texture { pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }

// The radiance of a surface that sends out the power of the flake, which at depth 4 glows with 5
#declare Power = 100*pi*pi;
#macro Glow(Area)
    texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission Power/(pi*Area) } }
#end

box { <-100, -100, -1>, <100, 100, 0> pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }

object { Sphereflake(Reflecting_Depth) texture { Matt } translate <-2.1, 0, 1> }

union {
    #if (Luminaires = 1)
        sphere { <0, 0, 0>, 1 Glow(Sphereflake_Area(0)) }
        #if (Depth > 0)
            object { Sphereflake_Children(Depth) texture { Matt } }
        #end
    #else
        object { Sphereflake(Depth) Glow(Sphereflake_Area(Depth)) }
    #end
    translate <2.1, 0, 1>
}
