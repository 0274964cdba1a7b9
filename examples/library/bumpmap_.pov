// SPDX-License-Identifier: CC0-1.0
// The set of Mandelbrot, brighter the longer a point stays: heights for bumps.
// The library's pictures/bumpmap_.png is this scene with +W320 +H200 +A0.1.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right 1.6*x up y }
box {
    <-0.8, -0.5, 0>, <0.8, 0.5, 1>
    pigment {
        mandel 60 exterior 1, 1 interior 0, 0
        color_map { [0 rgb 0] [0.02 rgb 0.25] [0.06 rgb 0.6] [0.15 rgb 1] [1 rgb 1] }
        scale 0.38 translate 0.2*x
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
