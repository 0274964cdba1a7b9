// SPDX-License-Identifier: GPL-3.0-or-later
// law photons, seed 211486031
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { count 1500 }
}
camera { orthographic
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { 0, 0.7
    texture { 
        pigment { rgb 1 transmit 1 }
        finish { diffuse 0.6 }
    }
    photons { target on refraction on reflection on }
    translate <-0.2, 0.9, 0>
}
sphere { 0, 0.7
    pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission 3/*light 1*/ /*no_luminaire*/ } 
    scale 0.8 translate <-1.3, 2.3, -0.9>
}
sky_sphere { pigment { rgb 1 } pigment { bozo color_map { [0.5 rgb 1 transmit 1] [0.8 rgb 1] } } emission 0.4/*light 2*/ luminaire/*luminaire*/ }
