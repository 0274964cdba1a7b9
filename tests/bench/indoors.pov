// SPDX-License-Identifier: GPL-3.0-or-later
// Light of sources and of the sky that is reflected from surface to surface. Scene: 1: a room that
// an area light lights through a door; 2: a box with a spot; 3: a room with a window in the sun; 4:
// the same under a grey sky; 5: balls on a plane, as in many scenes of POV-Ray.
#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced { bounces 8 #ifdef (Reflected) reflected_luminaires Reflected #end } } }
#ifndef (Scene) #declare Scene = 1; #end
#default { finish { ambient 0 diffuse 1 } }
#declare Wall = rgb <0.75, 0.72, 0.66>;
#if (Scene = 1)
  camera { location <0.5, 1.6, 0.5> look_at <3.6, 1.1, 3> angle 75 right 4/3*x }
  difference {
    box { <-0.2, -0.2, -0.2>, <8.4, 3.2, 4.2> }
    box { <0, 0, 0>, <4, 3, 4> }
    box { <4.2, 0, 0>, <8.2, 3, 4> }
    box { <3.9, -0.001, 2.2>, <4.3, 2.1, 3.1> }
    pigment { Wall } }
  light_source { <6.2, 2.9, 2>, 3 area_light 2*x, 2*z, 8, 8 jitter fade_distance 2 fade_power 2 }
  box { <1.4, 0, 2.4>, <2.2, 0.75, 3.2> pigment { rgb <0.6, 0.45, 0.3> } }
  sphere { <1.8, 1.0, 2.8>, 0.25 pigment { rgb <0.2, 0.4, 0.7> } }
#end
#if (Scene = 2)
  camera { location <0, 1, -3.4> look_at y angle 40 right 4/3*x }
  difference {
    box { <-1.1, -0.1, -4>, <1.1, 2.1, 1.1> }
    box { <-1, 0, -4.1>, <1, 2, 1> }
    pigment { gradient x colour_map { [0.01 rgb <0.7, 0.1, 0.1>] [0.01 Wall] [0.99 Wall] [0.99 rgb <0.1, 0.6, 0.1>] }
              scale 2.02 translate -1.01*x } }
  box { <-0.7, 0, 0.1>, <-0.1, 1.2, 0.7> pigment { Wall } rotate 17*y }
  box { <0.1, 0, -0.5>, <0.7, 0.6, 0.1> pigment { Wall } rotate -18*y }
  light_source { <0, 1.95, -0.6>, 8 spotlight point_at <-0.4, 0, 0.2> radius 14 falloff 18 }
#end
#if (Scene = 3 | Scene = 4)
  camera { location <0.6, 1.6, 0.5> look_at <2.4, 1.1, 3> angle 75 right 4/3*x }
  difference {
    box { <-0.2, -0.2, -0.2>, <4.2, 3.2, 5.2> }
    box { <0, 0, 0>, <4, 3, 5> }
    box { <3.9, 0.9, 1.5>, <4.3, 2.2, 3> }
    pigment { Wall } }
  plane { y, -0.2 pigment { rgb 0.3 } }
  box { <1.4, 0, 2.4>, <2.2, 0.75, 3.2> pigment { rgb <0.6, 0.45, 0.3> } }
  sphere { <1.8, 1.0, 2.8>, 0.25 pigment { rgb <0.2, 0.4, 0.7> } }
  #if (Scene = 3) light_source { <40, 34, -12>, rgb <12, 11, 9> parallel point_at 0 } #end
  #if (Scene = 4) sky_sphere { pigment { rgb <4, 4.4, 5> } luminaire } #end
#end
#if (Scene = 5)
  camera { location <0, 2, -6> look_at 0.8*y angle 45 right 4/3*x }
  plane { y, 0 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.2> } }
  #for (I, 0, 8)
    sphere { <mod(I, 3) * 1.5 - 1.5, 0.5, floor(I / 3) * 1.5 - 1>, 0.5 pigment { rgb <0.9 - I * 0.08, 0.4, 0.1 + I * 0.1> }
             finish { phong 0.6 reflection 0.1 } }
  #end
  light_source { <20, 30, -30>, 1 }
  light_source { <-30, 20, -10>, 0.4 }
#end
