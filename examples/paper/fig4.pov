// SPDX-License-Identifier: CC0-1.0
// Shirley and Wang, "Luminaire Sampling in Distribution Ray Tracing", Figure 4: one sphere lit by
// one large luminaire. From the rim of the lit side the luminaire's centre is below the horizon
// while part of it is still above; a sampler that forgets that part draws a hard dark edge here.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
    location <0, 0, -7>
    right x
    up y
    angle 24
    look_at <0, 0, 0>
}

sphere { <0, 0, 0>, 1 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }

sphere {
    <-4.4, 1.6, -1.2>, 3.2
    pigment { rgb 1 }
    finish { ambient 0 diffuse 0 emission 1.5 }
}
