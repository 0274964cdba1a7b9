// SPDX-License-Identifier: GPL-3.0-or-later
// 314,148 triangles in 2228 meshes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 30, -80> look_at 0 angle 50 }
light_source { <10, 200, -100>, rgb 1 }
#declare Random = seed(7);
#for (M, 1, 2228)
    mesh {
        #local Corner = <rand(Random)*60 - 30, rand(Random)*10, rand(Random)*60 - 30>;
        #for (I, 1, 141)
            #local Place = Corner + <rand(Random), rand(Random), rand(Random)>;
            triangle {
                Place, Place + <rand(Random), 0, rand(Random)>*0.2, Place + <0, rand(Random), rand(Random)>*0.2
            }
        #end
        pigment { rgb <rand(Random), rand(Random), 1> }
    }
#end
