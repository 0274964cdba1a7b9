// SPDX-License-Identifier: CC0-1.0
// A sheet of shapes, each about one unit wide: in the rows of even number they are lit, in the
// others they glow themselves.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 14, -12> right 4/3*x up y angle 32 look_at <0, 0, -0.2> }
light_source { <-6, 12, -8>, 0.8 }
plane { y, -0.75 pigment { rgb 0.5 } }

#declare Count = 24;
#declare Shapes = array[Count]
#declare Shapes[0] = sphere { 0, 0.6 }
#declare Shapes[1] = box { -0.45, 0.45 rotate 30*y }
#declare Shapes[2] = cylinder { -0.5*y, 0.5*y, 0.45 }
#declare Shapes[3] = cone { -0.5*y, 0.55, 0.5*y, 0.15 }
#declare Shapes[4] = torus { 0.45, 0.16 }
#declare Shapes[5] = superellipsoid { <0.3, 0.3> scale 0.5 rotate 20*y }
#declare Shapes[6] = ovus { 0.4, 0.25 }
#declare Shapes[7] = lathe {
    cubic_spline 6, <0, -0.7>, <0.3, -0.5>, <0.55, -0.1>, <0.2, 0.3>, <0.4, 0.6>, <0.5, 0.8> }
#declare Shapes[8] = sor {
    6, <0.3, -0.8>, <0.5, -0.5>, <0.3, -0.1>, <0.5, 0.3>, <0.2, 0.55>, <0, 0.8> }
#declare Shapes[9] = prism { -0.3, 0.3, 11
    #for (I, 0, 10) (mod(I, 2) ? 0.28 : 0.65)*<sin(36*I*pi/180), cos(36*I*pi/180)> #end }
#declare Shapes[10] = sphere_sweep { cubic_spline 6, <-0.8, -0.4, 0>, 0.1, <-0.5, -0.4, 0>, 0.12,
    <-0.2, 0.4, 0.2>, 0.16, <0.2, -0.3, -0.2>, 0.2, <0.5, 0.4, 0>, 0.1, <0.8, 0.6, 0>, 0.1 }
#declare Shapes[11] = blob { threshold 0.5 sphere { -0.3*x, 0.6, 1 } sphere { 0.3*x, 0.6, 1 }
    cylinder { 0, 0.5*y, 0.4, 1 } }
#declare Shapes[12] = quadric { <1, -0.6, 1>, 0, 0, -0.1 clipped_by { box { -0.55, 0.55 } } }
#declare Shapes[13] = disc { 0, <0, 1, -0.6>, 0.6, 0.25 }
#declare Shapes[14] = polygon { 5, <-0.5, -0.4>, <0.6, -0.4>, <0.3, 0.5>, <-0.3, 0.5>, <-0.5, -0.4>
    rotate 30*x }
#declare Shapes[15] = mesh {
    triangle { -0.5*x - 0.5*y, 0.5*x - 0.5*y, 0.6*y }
    triangle { 0.5*x - 0.5*y, 0.7*z - 0.5*y, 0.6*y }
    triangle { 0.7*z - 0.5*y, -0.5*x - 0.5*y, 0.6*y }
    rotate 160*y }
#declare Shapes[16] = isosurface {
    function { x*x + y*y + z*z - 0.24 + 0.06*sin(12*x)*sin(12*y)*sin(12*z) }
    contained_by { sphere { 0, 0.7 } } }
#declare Shapes[17] = julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8
    precision 30 scale 0.55 }
#declare Shapes[18] = height_field { function 60, 60 { 0.5 + 0.4*sin(9*x)*cos(9*y) } smooth
    translate -0.5 scale <1.1, 0.8, 1.1> rotate 25*y }
#declare Shapes[19] = bicubic_patch { type 1 flatness 0.001 u_steps 4 v_steps 4
    <0, 0, 0> <1, 1, 0> <2, -1, 0> <3, 0, 0> <0, 1, 1> <1, 2, 1> <2, 1, 1> <3, 0, 1>
    <0, -1, 2> <1, 1, 2> <2, 2, 2> <3, 1, 2> <0, 0, 3> <1, 0, 3> <2, 1, 3> <3, 0, 3>
    translate <-1.5, 0, -1.5> scale 0.36 }
#declare Shapes[20] = parametric {
    function { (1 + 0.4*cos(v))*cos(u) }, function { 0.4*sin(v) + 0.2*sin(3*u) },
    function { (1 + 0.4*cos(v))*sin(u) } <0, 0>, <2*pi, 2*pi>
    contained_by { box { -1.5, 1.5 } } scale 0.42 }
#declare Shapes[21] = intersection { box { -0.45, 0.45 } sphere { 0, 0.6 } }
#declare Shapes[22] = difference {
    sphere { 0, 0.6 } cylinder { -z, z, 0.3 } cylinder { -x, x, 0.2 } }
#declare Shapes[23] = merge { torus { 0.4, 0.12 } torus { 0.4, 0.12 rotate 90*x } }

#for (I, 0, Count - 1)
    #local Colour = 0.5 + 0.4*<sin(I), sin(I + 2), sin(I + 4)>;
    #local Row = div(I, 6);
    object {
        Shapes[I]
        #if (mod(Row, 2))
            pigment { rgb Colour } finish { ambient 0 diffuse 0 emission 2 }
        #else
            pigment { rgb Colour } finish { ambient 0 diffuse 0.9 }
        #end
        translate <1.7*(mod(I, 6) - 2.5), 0, 1.9*(1.5 - Row)>
    }
#end
