// SPDX-License-Identifier: CC0-1.0
// A set of Julia in bands of colour.
// The library's pictures/mtmandj.png is this scene with +W320 +H200 +A0.1.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right 1.6*x up y }
box {
    <-0.8, -0.5, 0>, <0.8, 0.5, 1>
    pigment {
        julia <-0.75, 0.12>, 40 exterior 1, 1 interior 0, 0
        color_map {
            [0 rgb <0, 0, 0.6>] [0.06 rgb <0, 0, 0.6>]
            [0.06 rgb <0, 0.6, 0>] [0.1 rgb <0, 0.6, 0>]
            [0.1 rgb <0, 0.6, 0.6>] [0.16 rgb <0, 0.6, 0.6>]
            [0.16 rgb <0.75, 0, 0>] [0.3 rgb <0.75, 0, 0>]
            [0.3 rgb <0.8, 0, 0.6>] [0.45 rgb <0.8, 0, 0.6>]
            [0.45 rgb 1] [1 rgb <0.2, 0.2, 0.8>]
        }
        scale 0.3 rotate -20*z
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
