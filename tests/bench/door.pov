// SPDX-License-Identifier: GPL-3.0-or-later
// A room that is lit through a door, by lamps in the next one, with all bounces of light.
#version 3.7;
#ifdef (Rival) global_settings { light_sampler { light_bvh { mis } } } #end
global_settings { assumed_gamma 1 integrator { path_traced { bounces 8 #ifdef (Reflected) reflected_luminaires Reflected #end } } }
camera { location <0.5, 1.6, 0.5> look_at <3.6, 1.1, 3> angle 75 right 4/3*x }
#declare Matt = finish { ambient 0 diffuse 1 };
// Two rooms of 4 by 4 m and 4 by 4 m with a door between them; the lamps are in the other one.
difference {
  box { <-0.2,-0.2,-0.2>, <8.4,3.2,4.2> }
  box { <0,0,0>, <4,3,4> }
  box { <4.2,0,0>, <8.2,3,4> }
  box { <3.9,-0.001,2.2>, <4.3,2.1,3.1> }
  pigment { rgb <0.75,0.72,0.66> } finish { Matt } }
#for (I, 0, 4) #for (J, 0, 4)
  box { <4.6+I*0.75,2.96,0.35+J*0.75>, <4.8+I*0.75,2.98,0.55+J*0.75> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 30 } }
#end #end
box { <1.4,0,2.4>, <2.2,0.75,3.2> pigment { rgb <0.6,0.45,0.3> } finish { Matt } }
sphere { <1.8,1.0,2.8>, 0.25 pigment { rgb <0.2,0.4,0.7> } finish { Matt } }
