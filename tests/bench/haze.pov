// SPDX-License-Identifier: CC0-1.0
// A city at night in thin haze: 10,000 street lamps between 400 houses. Only the air is seen: all
// surfaces are black, and lamps do not show. Declare=Rival=1 draws distances by transmittance alone
// and lamps by light_bvh.
#version 3.7;
#include "light_arrays.inc"
#ifdef (Rival) global_settings { light_sampler { light_bvh { exponential } } } #end
#default { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
camera { location <-6, 19, -50> right 4/3*x angle 46 look_at <2, 6, 0> }
media { scattering { 1, 0.002 } }
#declare Random = seed(5);
#declare Streets = 20;
#declare Pitch = 5;
#for (I, 0, Streets - 1)
    #for (J, 0, Streets - 1)
        #declare Half = 1.2 + 0.6*rand(Random);
        #declare Rise = 2 + 9*pow(rand(Random), 2);
        box {
            <-Half, 0, -Half>, <Half, Rise, Half>
            translate Pitch*<I - (Streets - 1)/2, 0, J - (Streets - 1)/2>
        }
    #end
#end
#declare Lamp = sphere {
    <0, 0.6, 0>, 0.05
    pigment { rgb <1, 0.6, 0.22> }
    finish { ambient 0 diffuse 0 emission 60 }
    no_image
}
#for (I, 0, Streets)
    #declare Where = (I - Streets/2)*Pitch;
    object { Light_Grid(Lamp, <Streets*12, 1, 1>, <Pitch/12, 0, 0>) translate Where*z }
    object { Light_Grid(Lamp, <1, 1, Streets*12>, <0, 0, Pitch/12>) translate Where*x }
#end
plane { y, 0 }
