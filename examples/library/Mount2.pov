// SPDX-License-Identifier: CC0-1.0
// One mountain that rises from hills: heights for fields.
// The library's pictures/Mount2.png is this scene with +W250 +H250.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right x up y }
#declare Rough = function(x, y) { f_ridged_mf(x*4 + 1, y*4 + 7, 0.6, 0.8, 2.1, 6, 0.8, 2, 2) }
box {
    <-0.5, -0.5, 0>, <0.5, 0.5, 1>
    pigment {
        function { min(0.999, (0.1 + 0.9*exp(-9*(x*x + y*y)))*(0.45 + 0.35*Rough(x, y))) }
        color_map { [0 rgb 0] [1 rgb 1] }
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
