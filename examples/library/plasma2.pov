// SPDX-License-Identifier: CC0-1.0
// Clouds of colour, fine ones.
// The library's pictures/plasma2.png is this scene with +W100 +H100.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right x up y }
box {
    <-0.5, -0.5, 0>, <0.5, 0.5, 1>
    pigment {
        bozo turbulence 0.8 octaves 6 omega 0.6
        color_map {
            [0 rgb <0.1, 0.1, 0.6>]
            [0.35 rgb <0.1, 0.7, 0.7>]
            [0.5 rgb <0.9, 0.9, 0.2>]
            [0.7 rgb <0.9, 0.3, 0.1>]
            [1 rgb <0.5, 0, 0.5>]
        }
        scale 0.22 translate <0.3, 0.8, 0.2>
    }
    finish { emission 1 ambient 0 diffuse 0 }
}
