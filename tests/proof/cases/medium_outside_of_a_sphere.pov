// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 520516128
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { 0, 0.7
    inverse
    interior_texture { pigment { rgb 1 transmit 0.8 } finish { diffuse 0.3 } }
    hollow
    interior { media { emission 0.5/*light 0*/*<1, 0.8, 0.4> } luminaire/*luminaire*/ }
}
