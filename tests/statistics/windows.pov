// SPDX-License-Identifier: CC0-1.0
// Houses with windows that shine into the street only, and balls on the ground: the octree learns
// which way they lean.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 5, -9> look_at <0, 0.5, 0> right x up y angle 45 }
#declare Glow = texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 8 } }
#declare Matt = texture { pigment { rgb 0.6 } finish { ambient 0 diffuse 1 } }
#for (I, -1, 1)
    union {
        box { <-0.8, 0, -0.8>, <0.8, 1.6, 0.8> texture { Matt } }
        #for (J, 0, 3)
            box { <-0.3, 0.6, -0.82>, <0.3, 1.1, -0.78> texture { Glow } rotate 90*J*y }
        #end
        rotate 20*I*y
        translate <2.6*I, 0, 0.5*I>
    }
    sphere { <1.3*I, 0.1, -2>, 0.12 texture { Glow } }
#end
plane { y, 0 texture { Matt } }
