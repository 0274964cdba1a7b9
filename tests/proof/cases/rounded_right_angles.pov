// SPDX-License-Identifier: GPL-3.0-or-later
// law writing, seed 1918089741
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    integrator { path_traced bounces 3 reflected_luminaires 300 }
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
}
text { ttf "timrom.ttf" "Ea", 0.4, 0 translate -0.3 scale 1.3
    texture { pigment { checker rgb 1, rgb 0.9 } finish { diffuse 0.7 } }
    rotate <20, 130, -35>
    translate <-0.2, 0.9, 0>
}
light_source { <-2, 3, -2.5>, rgb 0.8/*light 1*/*<1, 0.9, 0.8> flux 20/*light 1*/ spotlight point_at <0, 0.5, 0> radius 20 falloff 30 }
