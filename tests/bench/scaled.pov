// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps of all sizes over a floor with boxes, all of it in a scale of one's own:
// Declare=Scale=1000. Declare=Shrink=0.7 makes each lamp so much smaller and nearer to one place
// than the one before: a geometric progression.
#version 3.7;
#ifndef (Scale) #declare Scale = 1; #end
#ifndef (Shrink) #declare Shrink = 1; #end
#ifndef (Lamps) #declare Lamps = 200; #end
#declare Random = seed(5);
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6>*Scale look_at <0, 0.4, 0>*Scale right x up y angle 60 }
#declare Matt = texture { pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }
union {
    box { <-9, -1, -9>, <9, 0, 9> texture { Matt } }
    #for (I, 0, 5) box { <I - 3, 0, 0>, <I - 2.7, 0.8, 1> texture { Matt } } #end
    #for (I, 0, Lamps - 1)
        #declare Size = pow(Shrink, I);
        sphere {
            <6*rand(Random) - 3, 1 + rand(Random), 4*rand(Random) - 2>*Size + (1 - Size)*y,
            (0.01 + 0.05*rand(Random))*Size
            pigment { rgb 1 }
            finish { ambient 0 diffuse 0 emission min(30/(Size*Size), 1e12) }
        }
    #end
    scale Scale
}
