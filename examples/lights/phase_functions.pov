// SPDX-License-Identifier: CC0-1.0
// The five ways of scattering light beside each other: a narrow beam through five balls of mist,
// lit from behind on the left and from the front on the right.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
    orthographic
    location <0, 0, -20>
    right 10.4*x
    up 6.2*y
    look_at 0
}
background { rgb 0.01 }

#declare Kinds = array[6][2] {
    { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0.6 }, { 5, -0.6 }
}
#for (I, 0, 5)
    #local Centre = <3.3*(mod(I, 3) - 1), 1.5 - 3*int(I/3), 0>;
    sphere {
        Centre, 1.4
        pigment { rgbt 1 }
        finish { ambient 0 diffuse 0 }
        hollow
        interior {
            media {
                #if (Kinds[I][0] = 5)
                    scattering { 5, rgb <0.16, 0.2, 0.26> eccentricity Kinds[I][1] }
                #else
                    scattering { Kinds[I][0], rgb <0.16, 0.2, 0.26> }
                #end
                samples 20
            }
        }
    }
    // A lamp on the rim of each ball, half behind it, as a small bright sphere
    sphere {
        Centre + <-0.8, 0.5, 0.6>, 0.045
        pigment { rgb 1 }
        finish { ambient 0 diffuse 0 emission 180 }
    }
#end
