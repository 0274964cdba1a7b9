// SPDX-License-Identifier: CC0-1.0
// 1, 100, 10,000 or a million luminaires of the same power altogether: the picture takes about as long.
// Render with Declare=Count=1000000 or any other number.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Count) #declare Count = 100; #end
camera { location <0, 3.2, -9> look_at <0, 0.9, 0> angle 48 }
#declare Matt = finish { ambient 0 diffuse 1 }
plane { y, 0 pigment { checker rgb 0.75 rgb 0.6 } finish { Matt } }
#for (I, 0, 6)
    cylinder { <3*sin(I*2*pi/7), 0, 3*cos(I*2*pi/7)>, <3*sin(I*2*pi/7), 1.6, 3*cos(I*2*pi/7)>, 0.22
        pigment { rgb <0.8, 0.75, 0.7> } finish { Matt } }
#end
sphere { <0, 0.8, 0>, 0.8 pigment { rgb <0.75, 0.8, 0.85> } finish { Matt } }

// A cloud over the place: all spheres together have the area of one with radius 0.5
#declare Random = seed(1);
#declare Size = 0.5/sqrt(Count);
#for (I, 1, Count)
    #local Turn = 2*pi*rand(Random);
    #local Away = (Count = 1 ? 0 : 3.6*sqrt(rand(Random)));
    sphere {
        <Away*sin(Turn), 2.9 + (Count = 1 ? 0 : 0.5*sin(2*Away) + 0.3*rand(Random)), Away*cos(Turn)>, Size
        pigment { rgb <1, 0.8, 0.55> } finish { ambient 0 diffuse 0 emission 7 }
    }
#end
