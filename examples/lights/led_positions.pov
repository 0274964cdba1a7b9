// SPDX-License-Identifier: CC0-1.0
// Light_Positions_Coloured and Light_Positions: LEDs at the vectors of an array, each in a colour
// from a second array. Here 400 of them make a torus knot; measured positions would be used the
// same way.
#version 3.7;
#include "colors.inc"
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <0, 2.9, -7.4>
    right 4/3*x
    up y
    angle 42
    look_at <0, 1.35, 0>
}

#declare Count = 400;
#declare Points = array[Count];
#declare Colours = array[Count];
#for (I, 0, Count - 1)
    #declare Angle = 2*pi*I/Count;
    #declare Reach = 1.5 + 0.55*cos(3*Angle);
    #declare Points[I] = <Reach*cos(2*Angle), 0.55*sin(3*Angle), Reach*sin(2*Angle)>;
    #declare Colours[I] = rgb 0.03 + CH2RGB(360*I/Count);
#end

#declare Led = sphere { <0, 0, 0>, 0.05 }
#declare Socket = cylinder { <0, 0, 0>, <0, 0.08, 0>, 0.02 }
union {
    object { Light_Positions_Coloured(Led, Points, Colours, 5) }
    object { Light_Positions(Socket, Points) pigment { rgb 0.3 } finish { ambient 0 diffuse 1 } }
    rotate -25*x
    translate 1.55*y
}

#declare Matt = finish { ambient 0 diffuse 1 }
plane { y, 0 pigment { rgb 0.5 } finish { Matt reflection 0.08 } }
plane { -z, -4 pigment { rgb 0.45 } finish { Matt } }
sphere { <0, 1.45, 0>, 0.55 pigment { rgb 0.75 } finish { Matt } }
