// SPDX-License-Identifier: GPL-3.0-or-later
// A closed room seen in infrared: walls of 12 Side^2 triangles that all glow by their temperature,
// and 16 boxes, two of them hot. Declare=Same=1 makes all as warm as each other.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Side) #declare Side = 29; #end
#ifndef (Same) #declare Same = 0; #end
#declare Random = seed(3);
camera { location <-0.9, 0.2, -0.9> look_at <0.3, -0.3, 0.3> right x up y angle 80 }
#macro Warmth(Place)
    #if (Same) 1 #else pow(1 + 0.15*sin(3*Place.x + 2*Place.y) + 0.1*sin(5*Place.z), 4) #end
#end
#macro Tile(A, B, C)
    triangle { A, B, C pigment { rgb 1 } finish { ambient 0 diffuse 0.4 emission Warmth((A + B + C)/3) } }
#end
#macro Wall(Corner, U, V)
    #for (I, 0, Side - 1)
        #for (J, 0, Side - 1)
            #local A = Corner + U*I/Side + V*J/Side;
            #local B = A + U/Side;
            #local C = A + V/Side;
            Tile(A, B, C)
            Tile(B, C, B + V/Side)
        #end
    #end
#end
Wall(<-1, -1, -1>, 2*x, 2*y)
Wall(<-1, -1, 1>, 2*x, 2*y)
Wall(<-1, -1, -1>, 2*x, 2*z)
Wall(<-1, 1, -1>, 2*x, 2*z)
Wall(<-1, -1, -1>, 2*y, 2*z)
Wall(<1, -1, -1>, 2*y, 2*z)
#for (I, 0, 15)
    box {
        -0.08, 0.08
        rotate 360*<rand(Random), rand(Random), rand(Random)>
        translate <mod(I, 4)*0.45 - 0.6, -0.85 + 0.3*rand(Random), div(I, 4)*0.45 - 0.6>
        pigment { rgb 1 }
        finish { ambient 0 diffuse 0.4 emission (Same ? 1 : (mod(I, 8) = 0 ? 16 : 1)) }
    }
#end
