// SPDX-License-Identifier: CC0-1.0
// Shirley and Wang, "Luminaire Sampling in Distribution Ray Tracing", Figure 2: four spheres of
// equal power over a diffuse plane, seen from above. The bigger the luminaire, the more the cosine
// varies over it, and the noisier its light: look with few samples (--samples 1).
#version 3.7;
global_settings { assumed_gamma 1.0 }

#declare Power = 60;
#declare Height = 1;
#declare Radii = array[4] { 0.08, 0.25, 0.5, 0.8 };

camera {
    location <0, 40, 0>
    up y
    right x
    sky z
    look_at <0, 0, 0>
    angle 11.4
}

plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }

#for (I, 0, 3)
    #declare Radius = Radii[I];
    sphere {
        <(mod(I, 2) - 0.5)*4, Height, (0.5 - div(I, 2))*4>, Radius
        pigment { rgb 1 }
        finish { ambient 0 diffuse 0 emission Power/(4*pi*pi*Radius*Radius) }
    }
#end
