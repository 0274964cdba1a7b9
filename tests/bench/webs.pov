// SPDX-License-Identifier: GPL-3.0-or-later
// A street of Count lamps on masts, which have photometric webs with Webs=1, and shine evenly with the flux of their files
// with Webs=0: all of one file, across the street, or with Turned=1 of ten files, turned at random. Needs
// +Ltests/photometry/files.
#version 3.7;
#ifndef (Count) #declare Count = 1000; #end
#ifndef (Webs) #declare Webs = 1; #end
#ifndef (Turned) #declare Turned = 0; #end
global_settings { assumed_gamma 1 photometry { unit 1 white 300 } integrator { path_traced bounces 2 } }
#default { finish { ambient 0 diffuse 0.8 } }
camera { location <3.5, 9, -25> look_at <3.5, 0, 10> angle 60 right 4/3*x }
#declare File = array[10] { "c-axial-2002.ies", "c-quadrant-1995.ies", "c-bilateral-1991.ies", "c-bilateral-90-270-2002.ies",
  "c-full-absolute-2019.ies", "b-flood-1995.ies", "isym0.ldt", "isym2.ldt", "isym3.ldt", "isym4.ldt" }
#declare Flux = array[10] { 3133.487, 2825.85, 2924.596, 1593.204, 1898.14, 4957.303, 3123.47, 3904.579, 7648.403, 3000.353 }
plane { y, 0 pigment { rgb 0.4 } }
#declare R = seed(3);
#for (I, 0, min(Count, 1000)/20)
  #for (J, 0, 1)
    box { <-12 + 20*J, 0, 0>, <-5 + 20*J, 6 + 8*rand(R), 8> translate (10*I - 40)*z pigment { rgb 0.3 + 0.4*rand(R) } }
  #end
#end
// A lamp on each metre of both sides, if there are 1000.
#for (I, 0, Count - 1)
  #local K = (Turned ? mod(I, 10) : 2);
  sphere { 0, 0.1 pigment { rgb 1 } no_image
    luminaire {
      #if (!Webs) flux lumen(Flux[K]) #else
        #if (K < 6) ies File[K] #else ldt File[K] #end
      #end
    }
    rotate (Turned ? 360*rand(R) : 180*mod(I, 2))*y
    translate <(mod(I, 2) ? 7.2 : -0.2), 6, -30 + 500*int(I/2)/Count*2> }
#end
