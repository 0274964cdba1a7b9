// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires that hide, touch and hold each other, over a floor, with glossy and smooth surfaces between.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0.7, 0> right x up y angle 55 }
box { <-20, -1, -20>, <20, 0, 20> pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 specular 0.4 roughness 0.05 } }
#declare Random = seed(7);
#for (I, 0, 149)
    sphere {
        <2*rand(Random) - 1, 0.3 + 1.6*rand(Random), 2*rand(Random) - 1>, 0.05 + 0.3*pow(rand(Random), 3)
        pigment { rgb <1, 0.5 + 0.5*rand(Random), 0.5> } finish { ambient 0 diffuse 0.3 emission 0.5 + 2*rand(Random) }
    }
#end
sphere { <-2, 0.6, -0.5>, 0.6 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
box { <1.5, 0, -2>, <2.2, 1.2, -1> pigment { rgb 0.8 } finish { ambient 0 diffuse 0.7 phong 0.5 phong_size 30 } }
