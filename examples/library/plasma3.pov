// SPDX-License-Identifier: CC0-1.0
// Clouds of colour, wide ones.
// The library's pictures/plasma3.png is this scene with +W100 +H100.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right x up y }
box {
    <-0.5, -0.5, 0>, <0.5, 0.5, 1>
    pigment {
        bozo turbulence 0.5 octaves 5 omega 0.5
        color_map {
            [0 rgb <0, 0.3, 0.1>]
            [0.4 rgb <0.2, 0.8, 0.3>]
            [0.55 rgb <0.9, 0.9, 0.8>]
            [0.7 rgb <0.3, 0.4, 0.9>]
            [1 rgb <0.1, 0, 0.4>]
        }
        scale 0.5 translate <3.1, 0.4, 1.2>
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
