// SPDX-License-Identifier: CC0-1.0
// A room at night that only the television lights. Its picture is a pigment of the screen, and light
// is drawn from where the picture is bright: most of it is dark.
#version 3.7;
global_settings { assumed_gamma 1 }

camera {
    location <-1.6, 1.5, -2.6>
    right x*image_width/image_height
    look_at <0.3, 0.6, 0.6>
    angle 62
}

#declare Wall = texture { pigment { rgb <0.75, 0.72, 0.68> } finish { ambient 0 diffuse 0.85 } }
box { <-2.5, -0.1, -3>, <2.5, 0, 2> texture { Wall pigment { rgb <0.5, 0.38, 0.28> } } }
box { <-2.5, 0, 2>, <2.5, 2.5, 2.1> texture { Wall } }
box { <2.5, 0, -3>, <2.6, 2.5, 2> texture { Wall } }

// The picture: a burning horizon below a dark sky, with a small sun in front.
#declare Night =
    pigment {
        gradient y
        colour_map {
            [0.00 rgb <0.002, 0.002, 0.004>]
            [0.33 rgb <0.004, 0.003, 0.006>]
            [0.36 rgb <1.0, 0.35, 0.06>]
            [0.45 rgb <0.20, 0.03, 0.06>]
            [0.75 rgb <0.004, 0.006, 0.02>]
            [1.00 rgb <0.001, 0.002, 0.008>]
        }
        scale 0.9
        translate 0.55*y
    }
box {
    <-0.1, 0.55, 1.5>, <1.5, 1.45, 1.53>
    texture { pigment { Night } finish { ambient 0 diffuse 0 emission 25 } }
}
sphere { <1.05, 1.02, 1.5>, 0.05 scale <1, 1, 0.02> translate 1.468*z pigment { rgb <1, 0.8, 0.5> } finish { ambient 0 diffuse 0 emission 40 } }
box { <-0.14, 0.51, 1.52>, <1.54, 1.49, 1.58> texture { Wall pigment { rgb 0.03 } } }
box { <-0.3, 0, 1.35>, <1.7, 0.45, 1.75> texture { Wall pigment { rgb <0.3, 0.2, 0.12> } } }

// Something to throw a shadow.
sphere { <-0.4, 0.3, 0.5>, 0.3 texture { Wall } }
cylinder { <1.3, 0, 0.2>, <1.3, 0.5, 0.2>, 0.2 texture { Wall } }
torus { 0.35, 0.08 translate <0.5, 0.08, -0.3> texture { Wall } }
