// SPDX-License-Identifier: CC0-1.0
// Light_Grid: three grids of 4 x 4 x 4 small lamps, each in its own colour, are set into each other
// over a dark, slightly polished floor.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <5.2, 3.6, -6.4>
    right 4/3*x
    up y
    angle 38
    look_at <0, 1.35, 0>
}

#macro Lamp(Colour)
    sphere { <0, 0, 0>, 0.05 pigment { Colour } finish { ambient 0 diffuse 0 emission 8 } }
#end

#declare Step = <0.75, 0.75, 0.75>;
union {
    object { Light_Grid(Lamp(rgb <1, 0.09, 0.02>), <4, 4, 4>, Step) translate <-0.25, 0, 0> }
    object { Light_Grid(Lamp(rgb <1, 0.45, 0.08>), <4, 4, 4>, Step) translate <0, 0.25, 0.25> }
    object { Light_Grid(Lamp(rgb <0.04, 0.1, 1>), <4, 4, 4>, Step) translate <0.25, -0.25, -0.25> }
    rotate 15*y
    translate 1.6*y
}

plane { y, 0 pigment { rgb 0.35 } finish { ambient 0 diffuse 1 reflection 0.08 } }
#for (I, 0, 11)
    sphere { <2.6, 0.22, 0>, 0.22 pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } rotate 30*I*y }
#end
