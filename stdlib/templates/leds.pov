// SPDX-License-Identifier: CC0-1.0
// LEDs from a table: write your own rows below, or read a file with Light_From_CSV.
//   candelabra leds.pov +W1280 +H720
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0.8 } }

camera {
    location <0, 1.6, -7> look_at <0, 1.5, 0> angle 55
    right x*image_width/image_height  // the shape of the picture
    film {
        exposure 1.6           // in stops
        response agx           // how bright light fades into white
        vignette 0.25
        glare { veil 0.1 halo 0.004 }
    }
}
background { rgb 0.002 }

// A stage: floor, wall, and haze that shows the light in the air.
plane { y, 0 pigment { rgb 0.15 } finish { microfacet { roughness 0.2 } } }
plane { -z, -3 pigment { rgb 0.3 } finish { diffuse 0.8 } }

// Columns of the table: x, y, z and the colour of each LED, as #rrggbb.
// Here they are made by a loop; a file is read by
//   Light_From_CSV(Led, "leds.csv", 40)
#declare Led = sphere { 0, 0.03 }
#declare Rows = 12;
#declare Columns = 40;
#for (Row, 0, Rows - 1)
    #for (Column, 0, Columns - 1)
        #local Wave = 0.5 + 0.5*sin(Column*0.35 + Row*0.5 + clock*2*pi);
        #local Hue = 0.5 + 0.5*cos(Column*0.12 - Row*0.2);
        object { Led
            translate <(Column - (Columns - 1)/2)*0.2, 0.6 + Row*0.2, 2.6>
            pigment { rgb <Hue*Hue, 0.12 + 0.2*Wave, (1 - Hue)*(1 - Hue)> }
            finish { diffuse 0 emission 12*(0.02 + Wave*Wave*Wave) }
        }
    #end
#end

// Something in front of them.
#for (I, -2, 2)
    cylinder { <1.5*I, 0, 0.4>, <1.5*I, 1.4 + 0.3*mod(abs(I), 2), 0.4>, 0.18
        pigment { rgb 0.5 }
        finish { microfacet { roughness 0.3 metallic 1 } }
    }
#end
