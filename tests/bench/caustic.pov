// SPDX-License-Identifier: GPL-3.0-or-later
// A ring of metal on a table under a chandelier of 1000 lamps: its caustic by photons, or by paths
// that meet the lamps by chance (Declare=Photons=0).
#version 3.7;
#ifndef (Photons) #declare Photons = 1; #end
global_settings {
    assumed_gamma 1
    #if (Photons) photons { count 60000 } #end
    integrator { path_traced { bounces 1 reflected_luminaires 0 } }
}
camera { location <0, 4, -4> look_at <0, 0, 0.1> angle 34 }
#default { finish { ambient 0 diffuse 1 } }
plane { y, 0 pigment { rgb 0.7 } }
difference {
    cylinder { -0.1*y, 0.6*y, 1.05 }
    cylinder { -y, y, 1 }
    pigment { rgb 0 }
    finish { diffuse 0 reflection 0.8 }
    #if (Photons) photons { target reflection on } #end
}
#for (I, 0, 999)
    #local Turn = radians(I*137.50776);
    sphere {
        <0.5*sqrt(I/1000)*cos(Turn), 4, 5 + 0.5*sqrt(I/1000)*sin(Turn)>, 0.01
        pigment { rgb 1 }
        finish { diffuse 0 emission 200 }
    }
#end
