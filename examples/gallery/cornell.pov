// SPDX-License-Identifier: CC0-1.0
// A room whose ceiling is set with 10,000 lamps, warm in the middle and cool at the edges. `radiosity` lets the walls
// light each other: without it the ceiling and all shadows are black.
#version 3.7;
global_settings {
    assumed_gamma 1
    max_trace_level 6
    radiosity { recursion_limit 4 max_sample 3 }
}
#default { finish { ambient 0 diffuse 0.85 } }

camera { location <0, 1.45, -4.6> right 4/3*x angle 52 look_at <0, 1.4, 0> }

#declare Wall = pigment { rgb 0.78 };
plane { y, 0 pigment { Wall } }
plane { -y, -3 pigment { Wall } }
plane { -z, -2 pigment { Wall } }
plane { z, -5 pigment { Wall } }
plane { x, -2 pigment { rgb <0.72, 0.1, 0.06> } }
plane { -x, -2 pigment { rgb <0.1, 0.45, 0.09> } }

#for (I, 0, 99)
    #for (J, 0, 99)
        #local Place = <-1.485 + 0.03*I, 2.93, -1.485 + 0.03*J>;
        #local Away = vlength(Place*<1, 0, 1>)/2.1;
        sphere {
            Place, 0.008
            pigment { rgb 1 }
            finish { diffuse 0 emission 18*((1 - Away)*<1, 0.62, 0.3> + Away*<0.3, 0.5, 1>) }
        }
    #end
#end

box { <-0.55, 0, -0.55>, <0.55, 1.75, 0.55> rotate 18*y translate <-0.75, 0, 0.75> pigment { Wall } }
box { <-0.5, 0, -0.5>, <0.5, 0.95, 0.5> rotate -17*y translate <0.75, 0, -0.35> pigment { Wall } }
sphere {
    <0.75, 1.37, -0.35>, 0.42
    pigment { rgb <0.95, 0.93, 0.9> }
    finish { diffuse 0.6 specular 0.3 roughness 0.02 reflection { 0.02, 0.3 fresnel } }
    interior { ior 1.5 }
}
