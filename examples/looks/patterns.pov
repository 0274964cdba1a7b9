// SPDX-License-Identifier: CC0-1.0
// A contact sheet of patterns, each on a tile of its own with the colours that it has by itself.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <3.5, -2.5, -10> look_at <3.5, -2.5, 0> right 8.2*x up 6.2*y }
box { <-10, -10, -11>, <20, 10, -10.9> pigment { rgb 1 } finish { emission 1 diffuse 0 } no_image }

#declare Tile = box { -0.46, 0.46 }
#macro Show(Column, Row, Look)
    object {
        Tile
        texture { pigment { Look } finish { ambient 0.3 diffuse 0.7 } }
        translate <Column, -Row, 0>
    }
#end

Show(0, 0, pigment { agate scale 0.3 })
Show(1, 0, pigment { bozo scale 0.15 })
Show(2, 0, pigment { boxed scale 0.5 translate -0.46*z })
Show(3, 0, pigment { brick scale 0.04 })
Show(4, 0, pigment { bumps scale 0.1 })
Show(5, 0, pigment { cells scale 0.15 })
Show(6, 0, pigment { checker scale 0.2 })
Show(7, 0, pigment { crackle scale 0.15 })
Show(0, 1, pigment { crackle solid scale 0.15 })
Show(1, 1, pigment { cubic rotate <20, 30, 0> translate -0.46*z })
Show(2, 1, pigment { cylindrical rotate 90*x scale 0.5 })
Show(3, 1, pigment { dents scale 0.1 })
Show(4, 1, pigment { gradient <1, 1, 0> scale 0.3 })
Show(5, 1, pigment { granite scale 0.5 })
Show(6, 1, pigment { hexagon rotate 90*x scale 0.12 })
Show(7, 1, pigment { julia <0.353, 0.288>, 30 interior 1, 1 scale 0.4 })
Show(0, 2, pigment { leopard scale 0.03 })
Show(1, 2, pigment { magnet 1 mandel 30 scale 0.2 translate <-0.2, 0, 0> })
Show(2, 2, pigment { mandel 50 scale 0.35 translate 0.2*x })
Show(3, 2, pigment { marble turbulence 0.6 scale 0.3 })
Show(4, 2, pigment { onion scale 0.15 })
Show(5, 2, pigment { planar scale 0.5 })
Show(6, 2, pigment { quilted scale 0.2 })
Show(7, 2, pigment { radial rotate 90*x frequency 3 })
Show(0, 3, pigment { ripples scale 0.1 })
Show(1, 3, pigment { spherical scale 0.7 })
Show(2, 3, pigment { spiral1 3 scale 0.2 })
Show(3, 3, pigment { spiral2 3 scale 0.2 })
Show(4, 3, pigment { spotted scale 0.1 })
Show(5, 3, pigment { square rotate 90*x scale 0.2 })
Show(6, 3, pigment { tiling 8 rotate 90*x scale 0.15 })
Show(7, 3, pigment { tiling 16 rotate 90*x scale 0.12 })
Show(0, 4, pigment { tiling 24 rotate 90*x scale 0.1 })
Show(1, 4, pigment { triangular rotate 90*x scale 0.2 })
Show(2, 4, pigment { waves scale 0.1 })
Show(3, 4, pigment { wood turbulence 0.04 scale 0.1 })
Show(4, 4, pigment { wrinkles scale 0.2 })
Show(5, 4, pigment { gradient x triangle_wave turbulence 0.4 scale 0.3 })
Show(6, 4, pigment { gradient x sine_wave frequency 3 scale 0.9 })
Show(7, 4, pigment {
    average pigment_map { [1 marble scale 0.2] [1 marble rotate 90*z scale 0.2] } })
Show(0, 5, pigment {
    gradient y pigment_map { [0.2 granite scale 0.2] [0.8 checker scale 0.1] } translate 0.5*y })
Show(1, 5, pigment { checker warp { turbulence 0.3 } scale 0.2 })
Show(2, 5, pigment { checker warp { black_hole 0, 2 strength 1.2 falloff 2 } scale 0.2 })
Show(3, 5, pigment {
    gradient x color_map { [0 rgb x] [1 rgb z] } warp { repeat x flip x } scale 0.25 })
Show(4, 5, pigment { brick scale 0.04 warp { spherical } scale 0.6 })
Show(5, 5, pigment {
    wood color_map { [0 rgb <1, 0.8, 0.4>] [1 rgb <0.5, 0.2, 0.1>] } scale 0.15 rotate 80*y })
Show(6, 5, pigment {
    pigment_pattern { crackle scale 0.2 }
    color_map { [0 rgb 0] [0.3 rgb <1, 0.4, 0>] [1 rgb 1] } })
Show(7, 5, pigment {
    granite turbulence 0.5
    color_map { [0 rgb <0.1, 0.2, 0.1>] [1 rgb <0.8, 0.9, 0.7>] } scale 0.4 })
