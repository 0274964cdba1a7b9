// SPDX-License-Identifier: GPL-3.0-or-later
// Many black holes in one pigment: Declare=Count=1000, Declare=Repeat=1 for those that are repeated.
#version 3.7;
#ifndef (Count) #declare Count = 1000; #end
#ifndef (Repeat) #declare Repeat = 0; #end
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 angle 50 }
light_source { <10, 10, -10>, rgb 1 }
#declare Random = seed(1);
plane {
    z, 0
    pigment {
        checker rgb 1, rgb 0 scale 0.2
        #for (I, 1, Count)
            warp { black_hole <rand(Random)*4 - 2, rand(Random)*4 - 2, 0>, 0.3 falloff 2 strength 1.2 #if (Repeat) repeat 2 #end }
        #end
    }
    finish { ambient 0.3 }
}
