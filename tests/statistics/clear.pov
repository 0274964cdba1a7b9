// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires that other things do not hide: some without shadows before each other, some within glass, some behind a
// pane of dark and clear squares.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0.7, 0> right x up y angle 55 }
box { <-20, -1, -20>, <20, 0, 20> pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } }
sphere { <-1.6, 0.6, -1>, 0.6 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.5 specular 0.5 roughness 0.05 } }
#declare Lamp = finish { ambient 0 diffuse 0 emission 3 }
#declare Random = seed(21);
#for (I, 0, 14)
    sphere {
        <1.5*rand(Random) - 2.5, 0.5 + 0.8*rand(Random), 1.5*rand(Random)>, 0.1 + 0.3*rand(Random)
        pigment { rgb <1, 0.5 + 0.5*rand(Random), 0.5> } finish { Lamp } no_shadow
    }
    union {
        box { -0.1, 0.1 pigment { rgb <0.5, 0.7, 1> } finish { Lamp } }
        sphere { 0, 0.2 pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { ambient 0 diffuse 0.1 } }
        translate <rand(Random), 0.5 + rand(Random), 2*rand(Random)>
    }
    sphere { <2.4, 0.3 + 1.5*rand(Random), 2*rand(Random) - 1>, 0.1 pigment { rgb 1 } finish { Lamp } }
#end
box { <2, 0, -1.5>, <2.05, 2, 1.5> pigment { checker rgb 0.5, rgbt <1, 0.9, 0.9, 0.9> scale 0.3 } finish { ambient 0 diffuse 0.5 } }
