// SPDX-License-Identifier: CC0-1.0
// Mountains between lakes: heights for fields.
// The library's pictures/fract003.png is this scene with +W320 +H200 +A0.1.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right 1.6*x up y }
box {
    <-0.8, -0.5, 0>, <0.8, 0.5, 1>
    pigment {
        bozo turbulence 0.6 octaves 6 omega 0.55
        color_map { [0 rgb 0] [0.42 rgb 0] [0.46 rgb 0.3] [0.6 rgb 0.65] [0.9 rgb 1] }
        scale 0.3 translate <0.3, 0.1, 0>
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
