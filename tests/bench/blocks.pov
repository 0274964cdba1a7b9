// SPDX-License-Identifier: GPL-3.0-or-later
// A city of Size*Size blocks with 100 lamps each. Apart=1 writes each lamp by itself.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Size) #declare Size = 100; #end
#ifndef (Apart) #declare Apart = 0; #end
camera { location <0, 12, -30> look_at 0 }
#default { finish { ambient 0 diffuse 0.8 } }
plane { y, -0.01 pigment { rgb 0.8 } }
#declare R = seed(1);
#declare Place = array[100];
#for (I, 0, 99) #declare Place[I] = <1.8*rand(R) - 0.9, 0.5*rand(R) + 0.05, 1.8*rand(R) - 0.9>; #end
#declare Bulb = sphere { 0, 0.3/Size pigment { rgb 1 } finish { emission 10 } }
#declare Block = union { #for (I, 0, 99) object { Bulb translate Place[I] } #end }
#for (X, 1, Size) #for (Z, 1, Size)
  #local There = 2*<X - Size/2, 0, Z - Size/2>;
  #if (Apart)
    #for (I, 0, 99) object { Bulb translate Place[I] + There } #end
  #else
    object { Block translate There }
  #end
#end #end
