// SPDX-License-Identifier: CC0-1.0
// A picture on shapes: above laid on space by map_type 0, 1, 2 and 5, below wrapped around them by
// uv_mapping. The picture is a function, so that no file is needed; a name in quotes would stand
// there instead.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.4, -11> look_at <0, 1.5, 0> angle 48 }
sphere { <-6, 10, -10>, 2 pigment { rgb 1 } finish { emission 50 diffuse 0 } }
background { rgb <0.8, 0.85, 0.9> }
plane { y, 0 pigment { rgb 0.9 } }

// Red grows with u, green with v; a dark net has eight meshes each way.
#declare Net = function { select(min(mod(8*x, 1), mod(8*y, 1)) - 0.12, 0.25, 1) }
#declare Board = pigment {
    average pigment_map {
        [1 function { Net(x, y, 0) } color_map { [0 rgb 0] [1 rgb <0, 0, 2>] }]
        [1 gradient x color_map { [0 rgb 0] [1 rgb <3, 0, 0>] }]
        [1 gradient y color_map { [0 rgb <0, 3, 0>] [1 rgb 0] }]
    }
}
#macro Picture(Type)
    image_map { function 256, 256 { pigment { Board } } map_type Type interpolate 2 }
#end

box { 0, 1 pigment { Picture(0) } translate <-4.2, 2.6, 0> }
sphere { 0, 0.7 pigment { Picture(1) } translate <-1.5, 3.1, 0> }
cylinder { 0, y, 0.6 pigment { Picture(2) } translate <1, 2.5, 0> }
torus { 1, 0.4 pigment { Picture(5) } rotate -60*x scale 0.65 translate <3.4, 3.1, 0> }

box { -0.5, 0.5 uv_mapping pigment { Picture(0) } rotate <-20, 30, 0> translate <-3.7, 0.9, 0> }
sphere { 0, 0.7 uv_mapping pigment { Picture(0) } rotate 40*z translate <-1.5, 0.8, 0> }
lathe {
    bezier_spline 4, <0.3, 0>, <1.3, 0.3>, <0.1, 0.8>, <0.5, 1.3>
    uv_mapping pigment { Picture(0) }
    translate <1, 0, 0>
}
torus { 1, 0.4 uv_mapping pigment { Picture(0) } rotate -60*x scale 0.65 translate <3.4, 0.9, 0> }
