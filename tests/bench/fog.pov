// SPDX-License-Identifier: CC0-1.0
// Lamps at random in fog over a floor, as many as Declare=N=... says, which give the same light together.
#version 3.7;
#ifndef (N) #declare N = 10000; #end
global_settings { assumed_gamma 1 }
camera { location <0, 3, -12> look_at <0, 2, 0> }
media { scattering { 5, 0.02 eccentricity 0.4 } }
#declare R = seed(1);
#for (I, 1, N)
    sphere {
        <20*rand(R) - 10, 0.3 + 5*rand(R), 30*rand(R) - 8>, 0.02
        pigment { rgb 1 }
        finish { emission 100000/N }
    }
#end
plane { y, 0 pigment { rgb 0.5 } }
