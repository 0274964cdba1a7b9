// SPDX-License-Identifier: CC0-1.0
// Shirley and Wang, "Luminaire Sampling in Distribution Ray Tracing", Figure 3: a sphere and two
// luminaires. Compare --light-sampler constant_alpha, linear_alpha and every_light at 1 and 20
// samples: one shadow ray to a luminaire chosen blindly, one to a luminaire chosen well, one to
// each.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
    location <0, 2.2, -7>
    right x
    up y
    angle 42
    look_at <0, 0.95, 0>
}

#declare Matt = finish { ambient 0 diffuse 1 }

sphere { <0, 1, 0>, 1 pigment { rgb 0.7 } finish { Matt } }
plane { y, 0 pigment { rgb 0.4 } finish { Matt } }

#declare Luminaire = sphere {
    <0, 0, 0>, 0.3
    pigment { rgb 1 }
    finish { ambient 0 diffuse 0 emission 40 }
}

object { Luminaire translate <-1.7, 2.6, -1.4> }
object { Luminaire translate <1.7, 2.6, -1.4> }
