// SPDX-License-Identifier: CC0-1.0
// A theatre marquee after the rain: a sign of bulbs in letters, a running border, two boards that
// shine through, and a ceiling full of bulbs over the doors, where people wait. Some 670
// luminaires.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }
background { rgb <0.006, 0.01, 0.025> }

camera {
    location <-5.4, 2.1, -11.6>
    right 16/9*x
    up y
    angle 57
    look_at <-0.15, 3.05, 0>
    film {
        exposure 0.7
        response filmic
        vignette 0.3
        glare { veil 0.1 halo 0.004 star 0.02 blades 6 angle 12 length 0.3 }
    }
}

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Brick = texture {
    pigment {
        brick pigment { rgb 0.2 }
        pigment {
            bozo
            scale <0.5, 0.16, 1>
            color_map { [0 rgb <0.2, 0.08, 0.06>] [1 rgb <0.4, 0.18, 0.13>] }
        }
        brick_size <0.5, 0.16, 0.5> mortar 0.018
    }
    normal { brick 0.4 brick_size <0.5, 0.16, 0.5> mortar 0.018 }
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
// The doors' glass: the foyer behind it is bright below its ceiling
#declare Glass = texture {
    pigment {
        gradient y
        color_map { [0 rgb <0.12, 0.03, 0.02>] [0.6 rgb <0.5, 0.2, 0.06>] [1 rgb <1, 0.5, 0.2>] }
        scale 2.6
    }
    finish { ambient 0 diffuse 0 emission 0.3 reflection 0.12 }
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
        #declare Word[Row][Column] = rgb Lit*<1, 0.26, 0.035>;
    #end
#end

// The sign with its border, and the canopy below it
box { <-3.3, 3.9, -2.2>, <3.3, 5.9, -1.9> texture { Enamel } }
object { Light_Matrix(sphere { <0, 0, 0>, 0.066 }, Word, 6, 0.19) translate <0, 4.9, -2.24> }
#declare Border = array[5] {
    <-3.15, 4.05, 0>, <3.15, 4.05, 0>, <3.15, 5.75, 0>, <-3.15, 5.75, 0>, <-3.15, 4.05, 0>
}
object { Light_Along(Bulb(rgb <1, 0.08, 0.04>, 0.045, 9), 110, Border) translate -2.24*z }
box { <-3.6, 2.9, -2.4>, <3.6, 3.9, 0> texture { Brass } }
#macro Words(Line, Height)
    #local Letters = text { internal 2 Line 0.02, 0.06*x };
    #local Middle = (min_extent(Letters) + max_extent(Letters))/2;
    object {
        Letters
        translate -Middle.x*x
        scale <0.33, 0.33, 1>
        translate <0, Height, -0.045>
        pigment { rgb <0.05, 0.005, 0.005> }
        finish { Matt }
    }
#end
#macro Board(Width, Line, Next)
    box {
        <-Width/2, 3.04, -0.02>, <Width/2, 3.76, 0>
        pigment { rgb <1, 0.9, 0.72> }
        finish { ambient 0 diffuse 0 emission 0.9 }
    }
    Words(Line, 3.46)
    Words(Next, 3.12)
#end
#declare Chase = Bulb(rgb <1, 0.42, 0.1>, 0.04, 10);
#macro Frame(Width, Count)
    #local Corners = array[5] {
        <-Width/2, 2.97, 0>, <Width/2, 2.97, 0>, <Width/2, 3.83, 0>, <-Width/2, 3.83, 0>,
        <-Width/2, 2.97, 0>
    };
    object { Light_Along(Chase, Count, Corners) }
#end
union {
    Board(6.7, "TONIGHT: 7381 LAMPS", "EVERY ONE OF THEM A STAR") Frame(7, 130)
    translate -2.43*z
}
union { Board(1.9, "MATINEE", "AT DUSK") Frame(2.2, 52) rotate 90*y translate <-3.63, 0, -1.2> }
object {
    Light_Grid(Bulb(rgb <1, 0.46, 0.14>, 0.045, 11), <26, 1, 9>, <0.27, 1, 0.26>)
    translate <0, 2.86, -1.25>
}

// The house: brick above, doors and posters below
box { <-14, 0, 0>, <14, 12, 1> texture { Brick } }
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
// People who wait
#declare Random = seed(4);
#for (I, 0, 6)
    union {
        sphere { 1.58*y, 0.115 }
        cone { 0.62*y, 0.24 + 0.06*rand(Random), 1.3*y, 0.2 }
        cone { 1.3*y, 0.2, 1.46*y, 0.07 }
        cylinder { -0.09*x, <-0.08, 0.7, 0>, 0.075 }
        cylinder { 0.1*x, <0.08, 0.7, 0>, 0.075 }
        pigment { rgb 0.03 + 0.12*<rand(Random), 0.5*rand(Random), 0.6*rand(Random)> }
        finish { Matt }
        scale 0.95 + 0.12*rand(Random)
        rotate 360*rand(Random)*y
        translate <-2.2 + 0.62*I + 0.5*div(I, 2), 0, -0.9 - 0.9*rand(Random)>
    }
#end

// The pavement, its kerb and the street, all wet
#declare Wet = finish { ambient 0 diffuse 0.8 specular 0.2 roughness 0.02 reflection 0.22 }
box {
    <-14, -0.2, -3.2>, <14, 0, 1>
    pigment { checker rgb 0.16, rgb 0.13 scale 0.9 }
    normal { bumps 0.05 scale 0.3 }
    finish { Wet }
}
plane {
    y, -0.15
    pigment { rgb 0.03 }
    normal { bumps 0.07 scale <0.4, 1, 0.5> }
    finish { Wet }
}
