// SPDX-License-Identifier: CC0-1.0
// A theatre marquee: a sign of bulbs in letters, a running border, and a ceiling full of bulbs over
// the doors. Some 560 luminaires.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 }
background { rgb <0.004, 0.005, 0.01> }

camera {
    location <-5, 1.5, -10.5>
    right 4/3*x
    up y
    angle 54
    look_at <-0.1, 3.2, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Brick = texture {
    pigment { checker rgb <0.36, 0.15, 0.1>, rgb <0.42, 0.2, 0.13> scale <0.5, 0.24, 0.5> }
    finish { Matt }
}
#declare Enamel = texture {
    pigment { rgb <0.5, 0.03, 0.05> }
    finish { Matt phong 0.4 phong_size 60 reflection 0.05 }
}
#declare Brass = texture {
    pigment { rgb <0.5, 0.36, 0.14> }
    finish { ambient 0 diffuse 0.7 specular 0.6 roughness 0.03 reflection 0.25 }
}
#declare Glass = texture {
    pigment { rgb 0.03 }
    finish { ambient 0 diffuse 1 reflection 0.25 specular 0.4 }
}

#macro Bulb(Colour, Size, Radiance)
    sphere { <0, 0, 0>, Size pigment { Colour } finish { ambient 0 diffuse 0 emission Radiance } }
#end

// The word, a string for each row of bulbs
#declare Rows = array[7] {
    "#.....#...#.#...#.#####.#...#",
    "#.....#...#.##.##.#.....##..#",
    "#.....#...#.#.#.#.#.....#.#.#",
    "#.....#...#.#...#.####..#.#.#",
    "#.....#...#.#...#.#.....#..##",
    "#.....#...#.#...#.#.....#...#",
    "#####..###..#...#.#####.#...#"
}
#declare Word = array[7][29];
#for (Row, 0, 6)
    #for (Column, 0, 28)
        #declare Lit = (asc(substr(Rows[Row], Column + 1, 1)) = asc("#"));
        #declare Word[Row][Column] = rgb Lit*<1, 0.3, 0.05>;
    #end
#end

// The sign with its border, and the canopy below it
box { <-3.3, 3.9, -2.2>, <3.3, 5.9, -1.9> texture { Enamel } }
object { Light_Matrix(sphere { <0, 0, 0>, 0.062 }, Word, 7, 0.19) translate <0, 4.9, -2.24> }
#declare Border = array[5] {
    <-3.15, 4.05, 0>, <3.15, 4.05, 0>, <3.15, 5.75, 0>, <-3.15, 5.75, 0>, <-3.15, 4.05, 0>
}
object { Light_Along(Bulb(rgb <1, 0.08, 0.04>, 0.045, 9), 110, Border) translate -2.24*z }
box { <-3.6, 3.3, -2.4>, <3.6, 3.9, 0> texture { Brass } }
object { Light_Line(Bulb(rgb <1, 0.6, 0.24>, 0.05, 9), 60, <-3.5, 3.6, -2.44>, <3.5, 3.6, -2.44>) }
object { Light_Line(Bulb(rgb <1, 0.6, 0.24>, 0.05, 9), 20, <-3.64, 3.6, -2.3>, <-3.64, 3.6, -0.1>) }
object {
    Light_Grid(Bulb(rgb <1, 0.66, 0.32>, 0.045, 15), <26, 1, 9>, <0.27, 1, 0.26>)
    translate <0, 3.26, -1.25>
}

// The house: brick above, doors and posters below
box { <-9, 0, 0>, <9, 9, 1> texture { Brick } }
#for (I, -2, 2)
    box { <-0.48 + 1.1*I, 0, -0.06>, <0.48 + 1.1*I, 2.5, 0.1> texture { Glass } }
    box { <-0.55 + 1.1*I, 0, -0.1>, <-0.48 + 1.1*I, 2.6, 0.1> texture { Brass } }
    cylinder { <0.36 + 1.1*I, 0.8, -0.14>, <0.36 + 1.1*I, 1.5, -0.14>, 0.03 texture { Brass } }
#end
box { <-2.75, 2.5, -0.1>, <2.75, 2.65, 0.1> texture { Brass } }
#for (Side, -1, 1, 2)
    box {
        <-0.6, 0.8, -0.08>, <0.6, 2.6, 0>
        pigment { rgb <0.7, 0.66, 0.5> }
        finish { Matt }
        translate 4.3*Side*x
    }
    box {
        <-0.5, 1.2, -0.1>, <0.5, 2.5, 0>
        pigment { rgb <0.12, 0.25, 0.4> }
        finish { Matt }
        translate 4.3*Side*x
    }
    sphere {
        <0, 1.9, -0.1>, 0.3
        pigment { rgb <0.75, 0.5, 0.1> }
        finish { Matt }
        translate 4.3*Side*x
    }
    object {
        Light_Grid(Bulb(rgb <1, 0.5, 0.15>, 0.03, 12), <2, 15, 1>, <1.3, 0.13, 1>)
        translate <4.3*Side, 1.7, -0.1>
    }
#end
box {
    <-9, -0.2, -4.5>, <9, 0, 1>
    pigment { checker rgb 0.4, rgb 0.34 scale 0.9 }
    finish { Matt reflection 0.12 }
}
plane { y, -0.2 pigment { rgb 0.12 } finish { Matt reflection 0.2 } }
