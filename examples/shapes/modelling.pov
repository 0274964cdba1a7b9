// SPDX-License-Identifier: CC0-1.0
// Meshes made from other things: an exact difference, a hull, a subdivided cube, lamps scattered
// over a blob, and a floor of Voronoi's cells, some of which glow.
#version 3.7;
#include "light_arrays.inc"

global_settings { assumed_gamma 1 }
camera { location <0, 4.2, -8> look_at <0, 0.55, 0.2> angle 46 }
background { rgb <0.02, 0.025, 0.04> }
disc { <-3, 8, -3>, <0.3, -1, 0.3>, 2.5 pigment { rgb <1, 0.95, 0.85> } finish { emission 3 diffuse 0 } }

// ---- The floor -----------------------------------------------------------------------------------

#declare Random = seed(7);
#declare Count = 160;
#declare Points = array[Count];
#for (I, 0, Count - 1)
    #declare Points[I] = <12*rand(Random) - 6, 12*rand(Random) - 4>;
#end
#for (I, 0, Count - 1)
    #local Cell = voronoi_cell(Points, I, <-6, -4>, <6, 8>);
    #local Corners = dimension_size(Cell, 1);
    #local Lit = (rand(Random) < 0.12);
    prism {
        0, 0.1, Corners + 1
        #for (K, 0, Corners) #local P = Cell[mod(K, Corners)]; Points[I] + 0.94*(P - Points[I]) #end
        translate (Lit ? -0.02 : -0.1)*y
        #if (Lit)
            pigment { rgb <1, 0.75, 0.45> } finish { emission 0.9 diffuse 0 }
        #else
            pigment { rgb 0.25 + 0.15*rand(Random) }
        #end
    }
#end

// ---- What stands on it ---------------------------------------------------------------------------

mesh {
    difference {
        intersection { box { -1, 1 } sphere { 0, 1.32 } }
        cylinder { -2*x, 2*x, 0.62 }
        cylinder { -2*y, 2*y, 0.62 }
        cylinder { -2*z, 2*z, 0.62 }
    }
    resolution 48
    rotate 30*y
    scale 0.75
    translate <-2.7, 0.75, 0.3>
    pigment { rgb <0.75, 0.35, 0.25> }
}

mesh {
    convex_hull {
        torus { 0.75, 0.12 }
        sphere { 1.5*y, 0.25 }
        <0.9, 0.7, 0>
    }
    resolution 32
    translate <2.9, 0.12, 0.6>
    pigment { rgb <0.35, 0.55, 0.75> }
}

mesh {
    difference { box { -1, 1 } box { <-0.45, -2, -0.45>, <0.45, 2, 0.45> } }
    subdivide 3
    smooth
    rotate <-35, 0, 20>
    scale 0.55
    translate <0.9, 0.7, -1.7>
    pigment { rgb <0.45, 0.65, 0.35> }
}

#declare Body = blob {
    threshold 0.5
    sphere { <-0.45, 0, 0>, 1.1, 1 }
    sphere { <0.5, 0.25, 0.1>, 1, 1 }
    cylinder { 0, 1.5*y, 0.7, 0.9 }
}
#declare Lamp = sphere {
    0.03*x, 0.035
    pigment { rgb <0.75, 0.85, 1> }
    finish { emission 22 diffuse 0 }
}
union {
    object { Body pigment { rgb 0.5 } }
    Light_Scatter(Lamp, Body, 0.24, 1)
    translate <-0.3, 0.65, 1.6>
}
