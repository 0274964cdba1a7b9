// SPDX-License-Identifier: CC0-1.0
// Light_Street: 24 pairs of lamps along a road that runs to the horizon.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }
background { rgb <0.003, 0.004, 0.01> }

camera {
    location <-0.9, 1.9, -7>
    right 4/3*x
    up y
    angle 52
    look_at <0.1, 2, 10>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Iron = texture { pigment { rgb 0.12 } finish { ambient 0 diffuse 1 specular 0.3 } }

// Stands at the origin, its arm over +x
#declare Lamp = union {
    cylinder { <0, 0, 0>, <0, 4.2, 0>, 0.06 texture { Iron } }
    cylinder { <0, 4.2, 0>, <1.1, 4.4, 0>, 0.04 texture { Iron } }
    cone { <1.1, 4.34, 0>, 0.3, <1.1, 4.6, 0>, 0.05 texture { Iron } }
    sphere {
        <1.1, 4.3, 0>, 0.13
        pigment { rgb <1, 0.66, 0.3> }
        finish { ambient 0 diffuse 0 emission 200 }
    }
}
object { Light_Street(Lamp, 24, 6, 7.6) }

plane { y, -0.1 pigment { rgb 0.22 } finish { Matt } }
#for (Side, -1, 1, 2)
    box {
        <3.4*Side, -0.1, -10>, <7*Side, 0.04, 160>
        pigment { rgb <0.45, 0.43, 0.4> }
        finish { Matt }
    }
    #for (I, 0, 30)
        union {
            cylinder {
                <0, 0, 0>, <0, 1.2, 0>, 0.12
                pigment { rgb <0.3, 0.2, 0.12> }
                finish { Matt }
            }
            sphere { <0, 2.1, 0>, 1.1 pigment { rgb <0.2, 0.4, 0.14> } finish { Matt } }
            translate <6*Side, 0, 2.4 + 5*I>
        }
    #end
#end
#for (I, 0, 40)
    box {
        <-0.08, -0.1, 0>, <0.08, -0.09, 1.6>
        pigment { rgb 0.75 }
        finish { Matt }
        translate <0, 0, -6 + 4*I>
    }
#end
