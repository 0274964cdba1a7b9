// SPDX-License-Identifier: CC0-1.0
// A lantern festival at dusk: 840 paper lanterns rise over a lake, from the shore where people have
// let them go, and each is there once more in the water.
#version 3.7;
#include "light_arrays.inc"
#include "people.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

camera {
    location <0, 1.6, -11>
    right 16/9*x
    up y
    angle 56
    look_at <0, 3.4, 4>
    film {
        exposure 0.5
        response agx
        vignette 0.25
        glare { veil 0.1 halo 0.004 star 0 }
    }
}

// Dusk: a last light behind the hills, and a little from the sky above
sky_sphere {
    pigment {
        gradient y
        color_map {
            [0 rgb <0.3, 0.13, 0.08>] [0.07 rgb <0.12, 0.08, 0.12>]
            [0.25 rgb <0.02, 0.035, 0.09>] [0.8 rgb <0.004, 0.008, 0.03>]
        }
    }
}

light_source { <20, 90, -60>, rgb <0.02, 0.026, 0.05> parallel point_at 0 }

#declare Matt = finish { ambient 0 diffuse 1 }

// A lantern: thin paper around a flame, brightest below, with a wire hoop
#declare Lantern = union {
    torus { 0.13, 0.008 pigment { rgb <0.2, 0.1, 0.05> } finish { Matt } }
    cone { <0, 0, 0>, 0.13, <0, 0.2, 0>, 0.18 open }
    cone { <0, 0.2, 0>, 0.18, <0, 0.34, 0>, 0.19 open }
    cone { <0, 0.34, 0>, 0.19, <0, 0.43, 0>, 0.15 open }
    cone { <0, 0.43, 0>, 0.15, <0, 0.47, 0>, 0.04 }
    pigment {
        gradient y
        color_map {
            [0 rgb <1, 0.4, 0.09>*4] [0.4 rgb <1, 0.27, 0.04>*1.7] [1 rgb <1, 0.15, 0.02>*0.7]
        }
        scale 0.48
    }
    finish { ambient 0 diffuse 0 emission 1 }
}
object { Light_Box(Lantern, 560, <-30, 3, 6>, <30, 24, 60>, 1.6, 3) }
object { Light_Box(Lantern, 240, <-14, 1.2, 8>, <14, 9, 40>, 1.1, 14) }
object { Light_Box(Lantern, 36, <-7, 2.6, -4>, <7, 7, 4>, 1.3, 9) }
object { Lantern rotate 4*z translate <-2.2, 2.35, -8.3> }

// The lake with its ripples, and hills beyond it
plane {
    y, 0
    pigment { rgb <0.004, 0.008, 0.012> }
    normal { bumps 0.03 scale <1.6, 1, 0.5> }
    finish { ambient 0 diffuse 1 reflection { 0.02, 1 fresnel } }
    interior { ior 1.33 }
}
#declare Random = seed(5);
#for (I, 0, 12)
    sphere {
        0, 1
        scale <26 + 8*rand(Random), 5 + 5*rand(Random), 12>
        translate <-110 + 18*I, 0, 110 + 10*rand(Random)>
        pigment { rgb <0.16, 0.19, 0.24> }
        finish { Matt }
    }
#end

// Houses on the far shore
#declare Window = sphere {
    0, 0.14
    pigment { rgb <1, 0.45, 0.12> }
    finish { ambient 0 diffuse 0 emission 8 }
}
object { Light_Box(Window, 150, <-75, 0.3, 86>, <75, 2.4, 94>, 1, 31) }

// Two boats with people who hold a lantern
#declare Raised = <0.15, 1.74, -0.3>;
#declare Boat = union {
    // Planks between a rising keel and rising ends
    #for (I, -12, 12)
        #local Wide = 0.5*sqrt(1 - I*I/170);
        box { <-Wide, 0.0016*I*I - 0.05, 0.15*I - 0.08>, <Wide, 0.2 + 0.0022*I*I, 0.15*I + 0.08> }
    #end
    union {
        Person(Bun, Pale, Black, rgb <0.5, 0.1, 0.1>, Black, 0.25, Raised*Mirror, Raised, 0.02, 0)
        scale 0.64
        translate <0, 0.14, 0.45>
    }
    union {
        Person(Bare, Pale, Black, rgb <0.12, 0.16, 0.3>, Black, 0.7, Hang*Mirror, Raised, 0.02, 0)
        scale 0.68
        rotate 160*y
        translate <0, 0.14, -0.75>
    }
    pigment { rgb <0.4, 0.2, 0.12> }
    finish { Matt }
}
union {
    object { Boat } object { Lantern scale 0.8 translate <0, 1.25, 0.26> }
    rotate 62*y
    translate <2.9, 0, -1.8>
}
union {
    object { Boat } object { Lantern scale 0.8 translate <0, 1.25, 0.26> }
    rotate -48*y
    translate <-4.4, 0, 2.2>
}
