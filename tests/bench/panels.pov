// SPDX-License-Identifier: GPL-3.0-or-later
// A room of 12 by 9 metres under 108 panels, with all bounces of light.
#version 3.7;
#ifdef (Rival) global_settings { light_sampler { light_bvh { mis } } } #end
global_settings { assumed_gamma 1 integrator { path_traced { bounces 8 #ifdef (Reflected) reflected_luminaires Reflected #end } } }
camera { location <0.5, 1.7, 0.4> look_at <8, 1.2, 7> angle 75 right 4/3*x }
#declare Matt = finish { ambient 0 diffuse 1 };
box { <0,0,0>, <12,3,9> pigment { rgb <0.75,0.72,0.66> } finish { Matt } inverse }
plane { y, 0.001 pigment { checker rgb 0.5 rgb <0.35,0.25,0.18> } finish { Matt } }
plane { x, 0.001 pigment { rgb <0.7,0.25,0.2> } finish { Matt } inverse }
#for (I, 0, 11) #for (J, 0, 8)
  box { <0.35+I,2.96,0.35+J>, <0.65+I,2.98,0.65+J> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 9 } }
#end #end
#for (I, 0, 4)
  cylinder { <2+2*I, 0, 4+mod(I,2)>, <2+2*I, 0.75, 4+mod(I,2)>, 0.06 pigment { rgb 0.4 } finish { Matt } }
  cylinder { <2+2*I, 0.75, 4+mod(I,2)>, <2+2*I, 0.8, 4+mod(I,2)>, 0.6 pigment { rgb <0.6,0.45,0.3> } finish { Matt } }
  sphere { <2+2*I, 1.0, 4+mod(I,2)>, 0.2 pigment { rgb <0.2,0.4,0.7> } finish { Matt phong 0.4 } }
#end
