// SPDX-License-Identifier: GPL-3.0-or-later
// Many small lamps over rows of blocks: light sources (Kind 0: points, 1: spots) or glowing spheres (Kind 2).
#version 3.7;
#ifndef (Lamps) #declare Lamps = 10000; #end
#ifndef (Kind) #declare Kind = 0; #end
global_settings { assumed_gamma 1 }
camera { location <0, 9, -26> look_at <0, 0, -6> angle 60 }
plane { y, 0 pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } }
#declare Random = seed(3);
#for (I, 1, 300)
    #local Corner = <40*rand(Random) - 20, 0, 40*rand(Random) - 20>;
    box { Corner, Corner + <0.4 + rand(Random), 0.3 + 2*rand(Random), 0.4 + rand(Random)>
        pigment { rgb <0.6 + 0.3*rand(Random), 0.7, 0.7> } finish { ambient 0 diffuse 0.8 } }
#end
#for (I, 1, Lamps)
    #local Place = <40*rand(Random) - 20, 0.1 + 2.9*rand(Random), 40*rand(Random) - 20>;
    #local Tint = <1, 0.6 + 0.4*rand(Random), 0.4 + 0.5*rand(Random)>;
    #if (Kind = 2)
        sphere { Place, 0.02 pigment { rgb Tint } finish { emission 250*10000/Lamps*0.04 diffuse 0 } }
    #else
        light_source { Place, 0.002*10000/Lamps*Tint fade_distance 1 fade_power 2
            #if (Kind = 1) spotlight point_at Place - <rand(Random) - 0.5, 1, rand(Random) - 0.5> radius 25 falloff 45 #end
        }
    #end
#end
