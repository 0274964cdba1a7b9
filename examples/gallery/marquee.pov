// SPDX-License-Identifier: CC0-1.0
// A theatre marquee after the rain: a sign of bulbs in letters, a running border, two boards that
// shine through, a ceiling full of bulbs over the doors, and people who wait, meet and come late.
// Some 690 luminaires.
#version 3.7;
#include "light_arrays.inc"
#include "people.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 }
background { rgb <0.006, 0.01, 0.025> }

camera {
    location <-4.5, 1.3, -13>
    right 16/9*x
    up y
    angle 61
    look_at <0.25, 2.4, 0>
    film {
        exposure 0.8
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
            scale <0.26, 0.085, 1>
            color_map { [0 rgb <0.2, 0.08, 0.06>] [1 rgb <0.4, 0.18, 0.13>] }
        }
        brick_size <0.26, 0.085, 0.26> mortar 0.011
    }
    normal { brick 0.4 brick_size <0.26, 0.085, 0.26> mortar 0.011 }
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

// The house: brick around the doors, which stand open to a foyer of red velvet under globes
union {
    box { <-14, 2.5, 0>, <14, 12, 1> }
    box { <-14, 0, 0>, <-2.75, 2.5, 1> }
    box { <2.75, 0, 0>, <14, 2.5, 1> }
    texture { Brick }
}
box {
    <-5, 0, 4.2>, <5, 3.2, 4.3>
    pigment { rgb <0.5, 0.05, 0.04> }
    normal { gradient x 1.4 sine_wave scale 0.22 turbulence 0.1 }
    finish { Matt }
}
box { <-5, 2.9, 1>, <5, 3, 4.3> pigment { rgb <0.7, 0.5, 0.3> } finish { Matt } }
box { <-5, -0.02, 0>, <5, 0.004, 4.3> pigment { rgb <0.35, 0.07, 0.04> } finish { Matt } }
box { <-2.6, 0, 3.3>, <-0.4, 1.05, 3.8> texture { Brass } }
object {
    Light_Grid(Bulb(rgb <1, 0.62, 0.28>, 0.13, 5), <5, 1, 2>, <1.15, 1, 1.5>)
    translate <0.1, 2.45, 2.2>
}
object {
    Light_Grid(Bulb(rgb <1, 0.55, 0.2>, 0.07, 7), <6, 1, 1>, <1.2, 1, 1>)
    translate <0, 1.75, 4.1>
}
#for (I, 0, 5)
    box { <-0.05, 0, -0.1>, <0.05, 2.55, 0.1> texture { Brass } translate (-2.7 + 1.08*I)*x }
#end
#for (I, 0, 4)
    #if (I != 2)
        union {
            box { <0, 0.1, -0.03>, <0.06, 2.4, 0.03> }
            box { <0.88, 0.1, -0.03>, <0.94, 2.4, 0.03> }
            box { <0, 0.1, -0.03>, <0.94, 0.3, 0.03> }
            box { <0, 1.02, -0.02>, <0.94, 1.08, 0.02> }
            box { <0, 2.34, -0.03>, <0.94, 2.4, 0.03> }
            cylinder { <0.8, 0.85, -0.08>, <0.8, 1.45, -0.08>, 0.02 }
            texture { Brass }
            rotate (I = 3)*55*y
            translate <-2.63 + 1.08*I, 0, 0>
        }
    #end
#end
box { <-2.8, 2.5, -0.12>, <2.8, 2.66, 0.1> texture { Brass } }

// Windows above, one of them dark
#macro Window(Place, Glow)
    union {
        box { <-0.55, -0.06, -0.14>, <0.55, 0, 0.1> pigment { rgb 0.35 } finish { Matt } }
        box { <-0.4, 0, -0.03>, <0.4, 1.6, 0>
            pigment { gradient y color_map { [0 Glow*0.35] [1 Glow] } scale 1.6 }
            finish { ambient 0 diffuse 0.2 emission 0.2 reflection 0.05 }
        }
        box { <-0.4, 0.78, -0.05>, <0.4, 0.82, 0> }
        box { <-0.02, 0, -0.05>, <0.02, 1.6, 0> }
        difference {
            box { <-0.48, 0, -0.09>, <0.48, 1.7, 0> }
            box { <-0.4, -1, -1>, <0.4, 1.6, 1> }
        }
        pigment { rgb <0.25, 0.2, 0.16> }
        finish { Matt }
        translate Place
    }
#end
Window(<-6.7, 4.2, 0>, rgb <0.02, 0.03, 0.05>)
Window(<-4.9, 4.2, 0>, rgb <1, 0.5, 0.18>)
Window(<5.1, 4.2, 0>, rgb <0.03, 0.04, 0.06>)
Window(<6.7, 4.2, 0>, rgb <0.2, 0.4, 0.9>)

// Posters: a sun that sets in the sea, and a moon over the hills
#macro Poster(Sky, Ground, Disc, Title)
    box { <-0.62, 0.72, -0.06>, <0.62, 2.58, 0> texture { Brass } }
    box {
        <-0.54, 0.8, -0.08>, <0.54, 2.5, 0>
        pigment {
            gradient y
            color_map {
                [0.00 rgb 0.72*<1, 0.92, 0.75>]
                [0.20 rgb 0.72*<1, 0.92, 0.75>]
                [0.20 Ground]
                [0.50 Ground*1.4]
                [0.50 Sky]
                [1.00 Sky*0.25]
            }
            scale 1.7
            translate 0.8*y
        }
        finish { Matt }
    }
    intersection {
        cylinder { -0.085*z, 0*z, 0.3 translate 1.72*y }
        box { <-1, 1.65, -1>, <1, 3, 1> }
        pigment { Disc }
        finish { Matt }
    }
    #for (I, 0, 4)
        box {
            <-0.26 + 0.045*I, 1.61 - 0.065*I, -0.083>, <0.26 - 0.045*I, 1.585 - 0.065*I, 0>
            pigment { Disc }
            finish { Matt }
        }
    #end
    #local Letters = text { internal 2 Title 0.01, 0.04*x };
    #local Middle = (min_extent(Letters) + max_extent(Letters))/2;
    object {
        Letters
        translate -Middle.x*x
        scale <0.17, 0.2, 1>
        translate <0, 0.92, -0.085>
        pigment { rgb <0.05, 0.02, 0.02> }
        finish { Matt }
    }
    object {
        Light_Grid(Bulb(rgb <1, 0.5, 0.15>, 0.028, 12), <2, 15, 1>, <1.38, 0.13, 1>)
        translate <0, 1.65, -0.1>
    }
#end
union {
    Poster(rgb <0.75, 0.2, 0.12>, rgb <0.06, 0.14, 0.22>, rgb <0.9, 0.6, 0.12>, "LAST LIGHT")
    translate -4.3*x
}
union {
    Poster(rgb <0.08, 0.2, 0.42>, rgb <0.03, 0.06, 0.09>, rgb <0.85, 0.82, 0.7>, "MOONRISE")
    translate 4.3*x
}

// A couple arm in arm before the open doors
union {
    Person(Fedora, Pale, rgb 0.03, rgb <0.10, 0.075, 0.05>, Black, 0.52,
           Pocket*Mirror, Pocket, 0.03, -35)
    scale 1.05
    rotate 165*y
    translate <-0.02, 0, -1.5>
}
union {
    Person(Long_hair, Pale, rgb <0.22, 0.09, 0.03>, rgb <0.42, 0.03, 0.04>, Black, 0.6,
           <-0.13, 1.03, -0.2>, Hang, 0.02, 28)
    scale 0.97
    rotate 190*y
    translate <0.5, 0, -1.52>
}
// One who waits, with a telephone that lights the face
union {
    Person(Cap, Pale, rgb <0.35, 0.16, 0.03>, rgb <0.06, 0.12, 0.13>, Navy, 0.78,
           Pocket*Mirror, <0.06, 1.2, -0.27>, 0.02, 0)
    box {
        <-0.037, -0.075, -0.004>, <0.037, 0.075, 0.004>
        pigment { rgb <0.5, 0.75, 1> }
        finish { ambient 0 diffuse 0 emission 3 }
        rotate -35*x
        translate <0.045, 1.3, -0.34>
    }
    rotate 62*y
    translate <-2.5, 0, -1.9>
}
// A mother, and a child who points at the sign
union {
    Person(Bun, Dark, rgb 0.015, rgb <0.30, 0.22, 0.10>, Black, 0.45,
           <-0.3, 0.9, -0.03>, Hang, 0.04, 15)
    scale 0.98
    rotate 20*y
    translate <2.15, 0, -2.2>
}
union {
    Person(Cap, Dark, rgb <0.5, 0.06, 0.04>, rgb <0.12, 0.2, 0.36>, Navy, 0.8,
           <-0.36, 1.74, -0.3>, <0.33, 1.22, -0.02>, 0.03, 0)
    scale 0.64
    rotate 170*y
    translate <1.6, 0, -2.3>
}
// Two who talk under the canopy
union {
    Person(Bare, Pale, rgb <0.12, 0.06, 0.03>, rgb 0.07, Black, 0.74,
           Pocket*Mirror, <0.3, 1.12, -0.26>, 0.02, 0)
    scale 1.03
    rotate 80*y
    translate <-1.05, 0, -0.8>
}
union {
    Person(Fedora, Dark, rgb 0.05, rgb <0.16, 0.15, 0.13>, Black, 0.5, Hang*Mirror, Pocket, 0.02, 0)
    rotate -75*y
    translate <-1.75, 0, -0.75>
}
// One who comes late, with an umbrella, across the road
union {
    Person(Long_hair, Pale, rgb 0.02, rgb <0.05, 0.05, 0.07>, Black, 0.5,
           <-0.32, 0.86, -0.12>, <0.16, 1.2, -0.22>, 0.2, 0)
    union {
        Umbrella(rgb <0.35, 0.02, 0.025>)
        rotate 10*y
        rotate <4, 0, -5>
        translate <0.17, 1.86, -0.2>
    }
    rotate 150*y
    translate <1.15, -0.15, -5.8>
}

// What is left of the day, from the end of the street
light_source { <30, 16, -22>, rgb <0.012, 0.018, 0.034> parallel point_at 0 }

// The pavement, its kerb and the street, all wet, with puddles where the road is low
#declare Water = finish { ambient 0 diffuse 0.5 reflection { 0.15, 0.85 falloff 2.5 } }
#declare Damp = finish { ambient 0 diffuse 0.8 reflection { 0.05, 0.45 falloff 2.5 } }
box {
    <-14, -0.2, -3.2>, <14, 0, 0>
    pigment { checker rgb 0.15, rgb 0.12 scale 0.9 }
    normal { bumps 0.12 scale 0.2 }
    finish { Damp }
}
plane {
    y, -0.15
    texture {
        bozo
        turbulence 0.4
        scale <1.8, 1, 0.9>
        texture_map {
            [0.40
             pigment { rgb 0.015 }
             normal { bumps 0.06 scale <0.2, 1, 0.2> }
             finish { Water }
            ]
            [0.47
             pigment { granite color_map { [0 rgb 0.02] [1 rgb 0.06] } scale 0.3 }
             normal { granite 0.3 scale 0.12 }
             finish { Damp }
            ]
        }
    }
}
