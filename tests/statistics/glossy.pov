// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires of many sizes among surfaces that shine in every way there is.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0.7, 0> right x up y angle 55 }
box { <-20, -1, -20>, <0, 0, 20> pigment { rgb 0.7 } finish { ambient 0 microfacet { roughness 0.35 metallic 1 } } }
box { <0, -1, -20>, <20, 0, 20> pigment { rgb 0.7 } finish { ambient 0 microfacet { roughness 0.7 coat 1 coat_roughness 0.4 } } }
sphere { <-1.6, 0.6, -1>, 0.6 pigment { rgb 0.8 } finish { ambient 0 diffuse 0 phong 1 phong_size 30 } }
sphere { <1.6, 0.6, -1>, 0.6 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.5 specular 0.8 roughness 0.03 metallic } }
#declare Random = seed(9);
#for (I, 0, 79)
    sphere {
        <3*rand(Random) - 1.5, 0.4 + 1.6*rand(Random), 2*rand(Random)>, 0.02 + 0.3*pow(rand(Random), 3)
        pigment { rgb <1, 0.5 + 0.5*rand(Random), 0.5> } finish { ambient 0 diffuse 0 emission 0.5 + 2*rand(Random) }
    }
#end
