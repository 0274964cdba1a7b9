// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud of Unions unions of 100 glowing spheres each, which overlap.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Unions) #declare Unions = 10000; #end
#ifndef (Glow) #declare Glow = 1; #end
#ifndef (Turned) #declare Turned = 0; #end
#ifndef (Wide) #declare Wide = 3; #end
camera { location <0, 12, -30> look_at 0 }
#default { finish { ambient 0 diffuse 0.8 } }
plane { y, -11 pigment { rgb 0.8 } }
#if (!Glow) light_source { <20, 40, -30> rgb 1 } #end
#declare R = seed(1);
#declare Cluster = union {
  #for (I, 1, 100)
    sphere { <rand(R), rand(R), rand(R)> - 0.5, 1/pow(Unions, 1/3)/15 pigment { rgb 1 } #if (Glow) finish { emission 10 } #end }
  #end
}
#declare Spacing = 20/pow(Unions, 1/3);
#for (I, 1, Unions)
  object { Cluster scale Wide*Spacing #if (Turned) rotate 360*<rand(R), rand(R), rand(R)> #end translate 20*<rand(R), rand(R), rand(R)> - 10 }
#end
