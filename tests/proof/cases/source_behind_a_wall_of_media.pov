// SPDX-License-Identifier: GPL-3.0-or-later
// law point, seed 2421077694
// A wall of a solid with media is lit from outside, on both of its sides: the media inside dimmed light of a source that
// does not pass them.
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    integrator { path_traced bounces 2 reflected_luminaires 0 }
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
box { <-0.7, -0.6, -0.5>, <0.6, 0.7, 0.6>
    texture { pigment { rgb 1 transmit 1 } finish { diffuse 0 } }
    double_illuminate
    interior_texture { pigment { rgb 0.1 } finish { diffuse 0.5 } }
    hollow
    interior { media { scattering { 5, rgb <0.8, 0.6, 0.4> eccentricity 0.4 } } }
    translate <-0.2, 0.9, 0>
}
