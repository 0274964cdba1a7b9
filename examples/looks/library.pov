// SPDX-License-Identifier: CC0-1.0
// Textures of the standard library on spheres: metals, glass, stones, woods.
#version 3.7;
#include "colors.inc"
#include "textures.inc"
#include "metals.inc"
#include "golds.inc"
#include "glass.inc"
#include "stones.inc"
#include "woods.inc"
#include "skies.inc"
global_settings { assumed_gamma 1 max_trace_level 10 }

camera { location <0, 6, -13> look_at <0, 0.3, 0> angle 42 }
sky_sphere { S_Cloud1 }
plane { y, 0 texture { tiles { texture { T_Stone8 } tile2 texture { T_Grnt5 } } } }
sphere { <-8, 14, -9>, 1.5 pigment { rgb <1, 0.95, 0.85> } finish { emission 55 diffuse 0 } }

#macro Show(Column, Row, Look)
    sphere { <1.6*Column - 4, 0.6, 2.2*Row - 2.5>, 0.6 texture { Look } }
#end

Show(0, 0, T_Brass_3C) Show(1, 0, T_Copper_4D) Show(2, 0, T_Chrome_3E)
Show(3, 0, T_Silver_2B) Show(4, 0, T_Gold_3C) Show(5, 0, T_Gold_1A)
Show(0, 1, T_Stone1) Show(1, 1, T_Stone14) Show(2, 1, T_Stone25)
Show(3, 1, T_Grnt15) Show(4, 1, PinkAlabaster) Show(5, 1, T_Stone40)
Show(0, 2, T_Wood1) Show(1, 2, T_Wood7) Show(2, 2, T_Wood19)
Show(3, 2, T_Wood30) Show(4, 2, Rosewood) Show(5, 2, EMBWood1)
Show(0, 3, T_Winebottle_Glass) Show(1, 3, T_Ruby_Glass) Show(2, 3, Green_Glass)
Show(3, 3, Rust) Show(4, 3, Cork) Show(5, 3, New_Penny)
