// SPDX-License-Identifier: CC0-1.0
// Light_Ring: rings of lamps, one above the other, around a column of diffuse spheres.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <0, 4.2, -8>
    right 4/3*x
    up y
    angle 42
    look_at <0, 1.3, 0>
}

#declare Lamp = sphere {
    <0, 0, 0>, 0.07
    pigment { rgb <1, 0.62, 0.25> }
    finish { ambient 0 diffuse 0 emission 7 }
}

object { Light_Ring(Lamp, 60, 2.6) translate 0.12*y }
object { Light_Ring(Lamp, 40, 1.8) translate 1.2*y }
object { Light_Ring(Lamp, 24, 1.1) translate 2.3*y }

#declare Matt = finish { ambient 0 diffuse 1 }
sphere { <0, 0.8, 0>, 0.8 pigment { rgb <0.7, 0.68, 0.64> } finish { Matt } }
sphere { <0, 2.1, 0>, 0.5 pigment { rgb <0.7, 0.68, 0.64> } finish { Matt } }
sphere { <0, 2.9, 0>, 0.3 pigment { rgb <0.7, 0.68, 0.64> } finish { Matt } }
plane {
    y, 0
    pigment { checker rgb 0.45, rgb <0.16, 0.2, 0.28> scale 0.8 }
    finish { Matt reflection 0.06 }
}
