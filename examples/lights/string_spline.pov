// SPDX-License-Identifier: CC0-1.0
// Light_Spline_String: lamps follow a smooth curve through a few points, here a closed ribbon that
// weaves between standing stones. The curve is closed because the last point is the first.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 }

camera {
    location <0, 4.6, -8.4>
    right 4/3*x
    up y
    angle 44
    look_at <0, 0.7, -0.2>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Lamp = sphere {
    <0, 0, 0>, 0.045
    pigment { rgb <0.1, 0.5, 1> }
    finish { ambient 0 diffuse 0 emission 9 }
}

// The ribbon passes the twelve stones on the outside and on the inside in turn, up and down.
#declare Stones = 12;
#declare Knots = array[Stones + 1];
#for (I, 0, Stones)
    #declare Way = mod(I, 2)*2 - 1;
    #declare Knots[I] = vrotate(<2.6 + 0.55*Way, 0.75 + 0.5*Way, 0>, 360*I/Stones*y);
#end
#declare Knots[Stones] = Knots[0];

object { Light_Spline_String(Lamp, 200, Knots, 0) }

#for (I, 0, Stones - 1)
    box {
        <-0.14, 0, -0.3>, <0.14, 1.5, 0.3>
        pigment { rgb <0.72, 0.66, 0.6> }
        finish { Matt }
        translate 2.6*x
        rotate 360*I/Stones*y
    }
#end
sphere { <0, 0.8, 0>, 0.8 pigment { rgb <0.75, 0.72, 0.7> } finish { Matt } }
plane { y, 0 pigment { rgb <0.42, 0.36, 0.3> } finish { Matt } }
