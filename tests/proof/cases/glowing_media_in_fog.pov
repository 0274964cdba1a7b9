// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 4049144541
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    integrator { path_traced bounces 0 }
    light_sampler { light_bvh mis }
    max_trace_level 8
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
}
plane { y, -1 pigment { rgb 1 } finish { diffuse 1 } }
box { -9, 9 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } interior { media { emission 0.05/*light 0*/ absorption 0.05 } luminaire/*luminaire*/ } }
fog { rgb 0 distance 8 }
