// SPDX-License-Identifier: CC0-1.0
// Surfaces that patterns make bumpy, lit by one lamp from the side.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <2, -1.5, -10> look_at <2, -1.5, 0> right 5.2*x up 4.2*y }
sphere { <-6, 6, -8>, 1 pigment { rgb 1 } finish { emission 90 diffuse 0 } }

#macro Show(Column, Row, Bumps)
    sphere {
        0, 0.46
        pigment { rgb <0.9, 0.75, 0.5> }
        normal { Bumps }
        finish { diffuse 0.8 specular 0.3 roughness 0.02 }
        translate <Column, -Row, 0>
    }
#end

Show(0, 0, normal { bumps 0.8 scale 0.1 })
Show(1, 0, normal { dents 1.5 scale 0.1 })
Show(2, 0, normal { wrinkles 0.8 scale 0.2 })
Show(3, 0, normal { ripples 0.6 scale 0.1 })
Show(4, 0, normal { waves 0.5 scale 0.1 })
Show(0, 1, normal { quilted 1.2 scale 0.2 })
Show(1, 1, normal { facets coords 0.4 size 0.2 })
Show(2, 1, normal { granite 0.4 scale 0.4 })
Show(3, 1, normal { crackle 0.8 scale 0.15 })
Show(4, 1, normal { leopard 0.8 scale 0.03 })
Show(0, 2, normal { brick 0.6 scale 0.04 })
Show(1, 2, normal { onion 0.8 sine_wave scale 0.1 })
Show(2, 2, normal { hexagon 0.6 rotate 90*x scale 0.1 })
Show(3, 2, normal { marble 0.6 turbulence 0.5 scale 0.2 })
Show(4, 2, normal { spiral1 4 0.6 scale 0.15 })
Show(0, 3, normal {
    gradient x 0.8 slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.2 })
Show(1, 3, normal {
    gradient y normal_map { [0.3 bumps 0.8 scale 0.2] [0.7 ripples 0.6 scale 0.2] } scale 0.5 })
Show(2, 3, normal { average normal_map { [1 bumps 0.8 scale 0.3] [1 granite 0.5] } scale 0.3 })
Show(3, 3, normal { checker 0.5 scale 0.15 })
Show(4, 3, normal { wood 0.6 turbulence 0.05 scale 0.1 })
