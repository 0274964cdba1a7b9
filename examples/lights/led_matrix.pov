// SPDX-License-Identifier: CC0-1.0
// Light_Matrix: a sign of LEDs, whose colours are an array with two dimensions. The picture is
// drawn as strings, a letter for each colour; the sign hangs over a wet-looking pavement.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <-1.6, 1.1, -6.2>
    right 4/3*x
    up y
    angle 46
    look_at <0.1, 1.25, 0>
}

#declare Rows = array[9] {
    ".....r.........r.....",
    "....rrr...y...rrr....",
    "...rorrr.yyy.rrror...",
    "....rrr.yywyy.rrr....",
    ".....r.yywwwyy.r.....",
    "..b.....yywyy.....b..",
    ".bbb..g..yyy..g..bbb.",
    "bbcbbggg..y..gggbbcbb",
    ".bbb..g.......g..bbb."
}

#declare Picture = array[9][21];
#for (Row, 0, 8)
    #for (Column, 0, 20)
        #switch (asc(substr(Rows[Row], Column + 1, 1)))
            #case (asc("r")) #declare Picture[Row][Column] = rgb <1, 0.06, 0.03>; #break
            #case (asc("o")) #declare Picture[Row][Column] = rgb <1, 0.35, 0.04>; #break
            #case (asc("y")) #declare Picture[Row][Column] = rgb <1, 0.6, 0.05>; #break
            #case (asc("w")) #declare Picture[Row][Column] = rgb <1, 0.9, 0.7>; #break
            #case (asc("g")) #declare Picture[Row][Column] = rgb <0.08, 0.9, 0.15>; #break
            #case (asc("b")) #declare Picture[Row][Column] = rgb <0.05, 0.15, 1>; #break
            #case (asc("c")) #declare Picture[Row][Column] = rgb <0.2, 0.8, 1>; #break
            #else #declare Picture[Row][Column] = rgb 0;
        #end
    #end
#end

object { Light_Matrix(sphere { <0, 0, 0>, 0.07 }, Picture, 4, 0.19) translate <0, 1.6, 0> }

#declare Matt = finish { ambient 0 diffuse 1 }
box { <-2.2, 0.55, 0.08>, <2.2, 2.65, 0.2> pigment { rgb 0.12 } finish { Matt } }
cylinder { <-1.8, 0, 0.14>, <-1.8, 0.6, 0.14>, 0.06 pigment { rgb 0.3 } finish { Matt } }
cylinder { <1.8, 0, 0.14>, <1.8, 0.6, 0.14>, 0.06 pigment { rgb 0.3 } finish { Matt } }
plane { y, 0 pigment { rgb 0.4 } finish { Matt reflection 0.15 } }
#for (I, 0, 6)
    sphere {
        <-2.1 + 0.7*I, 0.18, -0.9 - 0.25*mod(I, 2)>, 0.18
        pigment { rgb 0.75 }
        finish { Matt }
    }
#end
