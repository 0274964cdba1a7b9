// SPDX-License-Identifier: GPL-3.0-or-later
// 49 spheres on a floor below an adaptive area light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 50 }
light_source { <10, 20, -10>, rgb 1 area_light 4*x, 4*z, 9, 9 adaptive 1 }
plane { y, -1 pigment { checker rgb 1, rgb 0.5 } }
#for (I, -3, 3)
    #for (J, -3, 3)
        sphere { <I, sin(I*J), J>, 0.4 pigment { rgb <1, 0.6, 0.4> } }
    #end
#end
