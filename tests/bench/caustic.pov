// SPDX-License-Identifier: GPL-3.0-or-later
// A glass ball on a table under a chandelier of 1000 lamps: its caustic by photons, or by paths that meet the lamps
// by chance (Declare=Photons=0).
#version 3.7;
#ifndef (Photons) #declare Photons = 1; #end
global_settings {
    assumed_gamma 1
    #if (Photons) photons { count 20000 } #end
    integrator { path_traced { bounces 3 } }
}
camera { location <0, 3, -6> look_at <0, 0.3, 0> angle 40 }
#default { finish { ambient 0 diffuse 1 } }
plane { y, 0 pigment { rgb 0.7 } }
sphere {
    <0, 0.8, 0>, 0.7
    pigment { rgbt 1 }
    finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy }
    interior { ior 1.5 }
    #if (Photons) photons { target reflection on refraction on } #end
}
#for (I, 0, 999)
    #local Turn = I*137.50776;
    sphere {
        <0.6*sqrt(I/1000)*cos(radians(Turn)), 6, 2 + 0.6*sqrt(I/1000)*sin(radians(Turn))>, 0.008
        pigment { rgb 1 }
        finish { diffuse 0 emission 150 }
    }
#end
