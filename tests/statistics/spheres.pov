// SPDX-License-Identifier: GPL-3.0-or-later
// Glowing spheres of all sizes between dark ones, and a floor.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0.5, 0> right x up y angle 60 }
#declare Matt = texture { pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
#declare R = seed(3);
box { <-20, -1, -20>, <20, 0, 20> texture { Matt } }
#for (I, 1, 60)
    sphere {
        <8*rand(R) - 4, 0.1 + 2*rand(R), 8*rand(R) - 4>, 0.02 + 0.3*rand(R)*rand(R)
        pigment { rgb <1, rand(R), rand(R)> } finish { ambient 0 diffuse 0 emission 0.5 + 6*rand(R) }
    }
    sphere { <8*rand(R) - 4, 0.3, 8*rand(R) - 4>, 0.3 texture { Matt } }
#end
