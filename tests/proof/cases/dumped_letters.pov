// SPDX-License-Identifier: GPL-3.0-or-later
// law writing, seed 3707107575
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { cylinder 1
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
}
sphere { 0, 0.7
    texture { pigment { gradient y color_map { [0 rgb 1] [0.4 rgb 1 transmit 1] } } finish { diffuse 0.6 } }
}
text { ttf "timrom.ttf" "Ea", 0.4, 0
    pigment { rgb 1 } finish { diffuse 0 emission 3/*light 0*/ /*no_luminaire*/ } 
}
