// SPDX-License-Identifier: GPL-3.0-or-later
// The sky as a light beside lamps: a room with a window (Place=1), blocks in the open (2), and the
// same under a sun (3). Lamps=0 leaves the lamps out.
#version 3.7;
#ifndef (Place) #declare Place = 1; #end
#ifndef (Lamps) #declare Lamps = 1; #end
global_settings { assumed_gamma 1 }
#default { pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } }
#if (Place = 1)
  camera { location <0, 1.5, -2.8> look_at <0, 1.2, 0> angle 70 }
  sky_sphere {
    pigment {
      gradient y color_map { [0.4 rgb <0.3, 0.4, 0.5>] [0.5 rgb <2, 2.5, 3.5>] [1 rgb <1, 1.6, 3>] }
      scale 2 translate -1
    }
    luminaire
  }
  difference {
    box { <-3.2, -0.2, -3.2>, <3.2, 3.2, 3.2> }
    box { <-3, 0, -3>, <3, 3, 3> }
    box { <-1, 1, 2.5>, <1, 2.4, 4> }
  }
  box { <-2, 0, 0>, <-1, 1, 1> }
  sphere { <1, 0.6, 0.5>, 0.6 }
  #if (Lamps)
    sphere { <-2, 2.6, 1>, 0.15 pigment { rgb 1 } finish { emission 6 diffuse 0 } }
    sphere { <2, 2.6, -1>, 0.15 pigment { rgb 1 } finish { emission 6 diffuse 0 } }
  #end
#else
  camera { location <0, 2, -8> look_at <0, 1, 0> angle 50 }
  sky_sphere {
    pigment {
      #if (Place = 2)
        gradient y color_map { [0.5 rgb <0.6, 0.7, 0.8>] [1 rgb <0.3, 0.5, 1>] }
        scale 2 translate -1
      #else
        function { min(1, max(0, 1 - ((x - 0.4)*(x - 0.4) + (y - 0.7)*(y - 0.7) + (z + 0.59)*(z + 0.59))*120)) }
        color_map { [0 rgb <0.15, 0.2, 0.3>] [1 rgb <150, 140, 110>] }
      #end
    }
    luminaire
  }
  plane { y, 0 }
  #for (I, -3, 3)
    box { <I - 0.3, 0, 0.5*I*I>, <I + 0.3, 1.5 + mod(I + 9, 3), 0.5*I*I + 0.6> }
    #if (Lamps)
      sphere { <I, 0.25, -1.5>, 0.2 pigment { rgb <1, 0.7, 0.3> } finish { emission 3 diffuse 0 } }
    #end
  #end
#end
