// SPDX-License-Identifier: CC0-1.0
// Ridges of mountains: heights for fields.
// The library's pictures/Mount1.png is this scene with +W250 +H250.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right x up y }
box {
    <-0.5, -0.5, 0>, <0.5, 0.5, 1>
    pigment {
        function {
            min(0.999, 0.42*f_ridged_mf(x*3.1 + 5, y*3.1 + 2, 0.3, 0.9, 2.2, 6, 0.9, 2.2, 2))
        }
        color_map { [0 rgb 0] [1 rgb 1] }
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
