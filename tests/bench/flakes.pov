// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figure 6 with a floor and 7381 luminaires that reflect half of what they receive,
// beside 7381 spheres that only reflect. Declare=Bounces=0 is light that comes straight.
#version 3.7;
#include "sphereflake.inc"
#ifndef (Bounces) #declare Bounces = 8; #end
global_settings {
    assumed_gamma 1
    integrator { path_traced { bounces Bounces #ifdef (Reflected) reflected_luminaires Reflected #end } }
}
camera { location <0, -10, 7> sky z right -4/3*x up y angle 50 look_at <0, 0, 0.7> }
#default { finish { ambient 0 diffuse 1 } }
box { <-100, -100, -1>, <100, 100, 0> pigment { rgb 0.5 } }
object { Sphereflake(4) pigment { rgb 0.7 } translate <-2.1, 0, 1> }
object {
    Sphereflake(4)
    pigment { rgb 0.5 }
    finish { emission 200*pi/Sphereflake_Area(4) }
    translate <2.1, 0, 1>
}
