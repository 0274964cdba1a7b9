// SPDX-License-Identifier: CC0-1.0
// A city of 100,000 lit windows at dusk, from the air: every window and every street lamp is a
// luminaire, and lights the streets, the houses opposite and the river.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 3 }

camera {
    location <-42, 25, -108>
    right 16/9*x
    up y
    angle 44
    look_at <0, 15, 40>
    film {
        exposure 0.7
        response agx
        vignette 0.25
        glare { veil 0.1 halo 0.003 star 0.012 blades 6 angle 10 length 0.25 }
    }
}
sky_sphere {
    pigment {
        gradient y
        color_map {
            [0 rgb <0.62, 0.2, 0.055>] [0.05 rgb <0.3, 0.12, 0.08>] [0.14 rgb <0.05, 0.06, 0.14>]
            [0.3 rgb <0.012, 0.025, 0.075>] [1 rgb <0.004, 0.01, 0.03>]
        }
    }
}
fog { fog_type 2 rgb <0.2, 0.09, 0.05> distance 900 fog_offset 0 fog_alt 12 }
// What is left of the day
light_source { <-100, 120, -60>, rgb <0.03, 0.045, 0.1> parallel point_at 0 }

#declare Across = 46;
#declare Beyond = 26;
#declare Matt = finish { ambient 0 diffuse 1 }
#declare Pitch = 5;
#declare Random = seed(2026);

// A window in the plane z = 0, facing -z, in four kinds of light
#declare Lights = array[4] { <1, 0.5, 0.18>, <1, 0.62, 0.3>, <1, 0.36, 0.1>, <0.55, 0.75, 1> }
#declare Windows = array[4];
#for (I, 0, 3)
    #declare Windows[I] = box {
        <-0.13, -0.17, -0.015>, <0.13, 0.17, 0.015>
        pigment { rgb Lights[I] }
        finish { ambient 0 diffuse 0 emission 2 }
    }
#end

// The lit windows of one side of a house, Across by Up, at the distance Away from its middle; in a
// floor where all are at work all are lit
#macro Side(Across, Up, Share, Kind, Away, Turn)
    #for (Row, 0, Up - 1)
        #local Late = (rand(Random) < 0.06 ? 0.95 : Share);
        #for (Column, 0, Across - 1)
            #if (rand(Random) < Late)
                object {
                    Windows[(rand(Random) < 0.75 ? Kind : int(4*rand(Random)))]
                    translate <(Column - (Across - 1)/2)*0.4, 0.5 + 0.55*Row, -Away>
                    rotate Turn*y
                }
            #end
        #end
    #end
#end
#macro House(Wide, Deep, Floors, Share, Kind)
    union {
        box {
            <-0.2*Wide - 0.1, 0, -0.2*Deep - 0.1>,
            <0.2*Wide + 0.1, 0.55*Floors + 0.4, 0.2*Deep + 0.1>
        }
        Side(Wide, Floors, Share, Kind, 0.2*Deep + 0.1, 0)
        Side(Wide, Floors, Share, Kind, 0.2*Deep + 0.1, 180)
        Side(Deep, Floors, Share, Kind, 0.2*Wide + 0.1, 90)
        Side(Deep, Floors, Share, Kind, 0.2*Wide + 0.1, -90)
        pigment { rgb (0.12 + 0.16*rand(Random))*<1, 0.92, 0.85> }
        finish { Matt }
    }
#end

// Blocks between streets: the nearer the middle, the higher; each tower carries a smaller one
#macro Hill(Place, Middle, Size)
    exp(-vdot(Place - Middle, Place - Middle)/Size)
#end
#for (I, 0, Across - 1)
    #for (J, 0, Beyond - 1)
        #declare Place = <I - (Across - 1)/2, 0, J>;
        #declare Rise = 62*Hill(Place, <2, 0, 8>, 30) + 30*Hill(Place, <-10, 0, 12>, 16);
        #declare Floors = 5 + int(6*rand(Random) + Rise*pow(rand(Random), 1.6));
        #declare Wide = 5 + int(4*rand(Random));
        #declare Deep = 5 + int(4*rand(Random));
        #declare Share = 0.16 + 0.34*rand(Random);
        #declare Kind = int(3.4*rand(Random));
        union {
            House(Wide, Deep, Floors, Share, Kind)
            #if (Floors > 24)
                object {
                    House(Wide - 2, Deep - 2, int(Floors*0.3), Share, Kind)
                    translate (0.55*Floors + 0.4)*y
                }
                cylinder {
                    0, 4*y, 0.06
                    translate (0.715*Floors + 0.8)*y
                    pigment { rgb 0.1 }
                    finish { Matt }
                }
                sphere {
                    0, 0.13
                    translate (0.715*Floors + 4.8)*y
                    pigment { rgb <1, 0.03, 0.02> }
                    finish { ambient 0 diffuse 0 emission 30 }
                }
            #end
            translate Pitch*Place
        }
    #end
#end

// Lamps along all streets
#declare Lamp = sphere {
    0.6*y, 0.05
    pigment { rgb <1, 0.5, 0.13> }
    finish { ambient 0 diffuse 0 emission 70 }
}
#for (I, 0, Beyond)
    object { Light_Grid(Lamp, <Across*3, 1, 1>, <Pitch/3, 0, 0>) translate (I - 0.5)*Pitch*z }
#end
#for (I, 0, Across)
    object {
        Light_Grid(Lamp, <1, 1, Beyond*3>, <0, 0, Pitch/3>)
        translate <I - Across/2, 0, Beyond/2 - 0.5>*Pitch
    }
#end

// The ground, and the river in front
box {
    <-Across/2, -0.1, -0.6>*Pitch, <Across/2, 0, Beyond>*Pitch
    pigment { rgb 0.12 }
    finish { Matt }
}
plane {
    y, -0.4
    pigment { rgb <0.006, 0.01, 0.014> }
    normal { bumps 0.05 scale <2.5, 1, 0.8> }
    finish { Matt reflection { 0.02, 1 fresnel } }
    interior { ior 1.33 }
}
