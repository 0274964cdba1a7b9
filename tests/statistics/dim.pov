// SPDX-License-Identifier: GPL-3.0-or-later
// Things that glow a little in the light of a lamp, as those do whose scenes say emission for ambient: what they give is
// small where the lamp shines, and everything in its shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0.5, 0> right x up y angle 60 }
light_source { <6, 9, -7>, rgb 1 }
#default { finish { ambient 0 diffuse 0.7 emission 0.05 } }
box { <-20, -1, -20>, <20, 0, 20> pigment { rgb 0.7 } finish { emission 0 } }
blob { threshold 0.6 sphere { <-1.5, 0.8, 0>, 1, 1 } sphere { <-0.6, 0.8, 0.3>, 1, 1 } pigment { rgb <0.9, 0.5, 0.3> } }
difference { box { <0.5, 0, 0>, <2, 1.5, 1.5> } cylinder { <1.2, 1, -1>, <1.2, 1, 3>, 0.4 } pigment { rgb <0.4, 0.8, 0.9> } }
isosurface {
    function { x*x + y*y + z*z - 0.5 + 0.1*sin(9*x)*sin(9*y) }
    contained_by { sphere { 0, 1 } } max_gradient 4
    translate <0.2, 0.9, -1.6>
    pigment { rgb 0.8 }
}
sphere { <-2.4, 0.4, -1>, 0.4 pigment { rgb 1 } }
#for (I, 0, 20)
    sphere { <-2.2 + 0.22*I, 0.1, -2.2>, 0.1 pigment { rgb <1, 0.6, 0.3> } }
#end
