// SPDX-License-Identifier: GPL-3.0-or-later
// Streets between houses with 8000 lamps, with all bounces of light.
#version 3.7;
#ifdef (Rival) global_settings { light_sampler { light_bvh { mis } } } #end
global_settings { assumed_gamma 1 integrator { path_traced { bounces 8 #ifdef (Reflected) reflected_luminaires Reflected #end } } }
camera { location <-30, 14, -30> look_at <20, 4, 20> angle 60 right 4/3*x }
#declare Matt = finish { ambient 0 diffuse 1 };
#declare R = seed(5);
plane { y, 0 pigment { rgb 0.3 } finish { Matt } }
#for (I, 0, 7) #for (J, 0, 7)
  #local H = 8 + 22*rand(R);
  box { <I*16,0,J*16>, <I*16+10,H,J*16+10> pigment { rgb <0.5,0.45,0.4>*(0.6+0.5*rand(R)) } finish { Matt } }
  #for (K, 0, 109)
    #local S = int(4*rand(R)); #local U = 0.6+8.4*rand(R); #local V = 0.8+(H-2)*rand(R);
    #local A = 0; 
    #if (S=0) #local A = <I*16+U, V, J*16-0.05>; #local B = A + <0.5,0.8,0.04>; #end
    #if (S=1) #local A = <I*16+U, V, J*16+10.01>; #local B = A + <0.5,0.8,0.04>; #end
    #if (S=2) #local A = <I*16-0.05, V, J*16+U>; #local B = A + <0.04,0.8,0.5>; #end
    #if (S=3) #local A = <I*16+10.01, V, J*16+U>; #local B = A + <0.04,0.8,0.5>; #end
    box { A, B pigment { rgb 1 } finish { ambient 0 diffuse 0 emission <3,2.2,1.2>*2 } }
  #end
  #for (K, 0, 14)
    sphere { <I*16-3, 4.5, J*16+K>, 0.15 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission <30,22,12> } }
  #end
#end #end
