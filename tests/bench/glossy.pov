// SPDX-License-Identifier: GPL-3.0-or-later
// The luminous sphereflake of the paper's Figure 6 beside surfaces that shine. Kind 0: facets of metal, 1: dull ones,
// 2: POV-Ray's highlights, 3: highlights only. Lamps: so many small spheres instead.
#version 3.7;
#include "sphereflake.inc"
global_settings { assumed_gamma 1.0 }
#ifndef (Kind) #declare Kind = 0; #end
#ifndef (Roughness) #declare Roughness = 0.4; #end
camera { location <0, -10, 7> sky z right -x up y angle 42 look_at <0, 0, 0.7> }
#switch (Kind)
    #case (0) #declare Shine = finish { ambient 0 microfacet { roughness Roughness metallic 1 } } #break
    #case (1) #declare Shine = finish { ambient 0 microfacet { roughness Roughness } } #break
    #case (2) #declare Shine = finish { ambient 0 diffuse 0.6 phong 1 phong_size 60 } #break
    #else #declare Shine = finish { ambient 0 diffuse 0 specular 1 roughness 0.01 }
#end
box { <-100, -100, -1>, <100, 100, 0> pigment { rgb 0.5 } finish { Shine } }
object { Sphereflake(2) pigment { rgb 0.7 } finish { Shine } translate <-2.1, 0, 1> }
#ifdef (Lamps)
    #declare Random = seed(3);
    #for (I, 1, Lamps)
        sphere { <12*rand(Random) - 6, 12*rand(Random) - 6, 0.1 + 2.9*rand(Random)>, 0.02
            pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 5e5/Lamps } }
    #end
#else
    object { Sphereflake(4) pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 100*pi*pi/(pi*Sphereflake_Area(4)) }
        translate <2.1, 0, 1> }
#end
