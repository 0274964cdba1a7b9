// SPDX-License-Identifier: CC0-1.0
// The flakes of the paper's Figure 6 in a box of fog that scatters light any number of times. All
// surfaces are black; Declare=Diffuse=1 lets them reflect, too. Declare=Reflected=0 leaves all light
// to paths from the camera.
#version 3.7;
#include "sphereflake.inc"
#ifndef (Bounces) #declare Bounces = 30; #end
global_settings { assumed_gamma 1.0 integrator { path_traced { bounces Bounces #ifdef (Reflected) reflected_luminaires Reflected #end } } }
#ifndef (Depth) #declare Depth = 4; #end
#ifndef (Sigma) #declare Sigma = 0.15; #end
#ifndef (Diffuse) #declare Diffuse = 0; #end
camera { location <0, -10, 7> sky z right -x up y angle 42 look_at <0, 0, 0.7> }
#declare Power = 100*pi*pi;
box { <-14, -14, -3>, <14, 14, 12> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 1, rgb Sigma multiple } } } }
box { <-13, -13, -1>, <13, 13, 0> pigment { rgb 0.5*Diffuse } finish { ambient 0 diffuse 1 } }
object { Sphereflake(Depth) texture { pigment { rgb 0.7*Diffuse } finish { ambient 0 diffuse 1 } } translate <-2.1, 0, 1> }
union { object { Sphereflake(Depth) texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission Power/(pi*Sphereflake_Area(Depth)) } } } translate <2.1, 0, 1> }
