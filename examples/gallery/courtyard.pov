// SPDX-License-Identifier: CC0-1.0
// A courtyard at night. All 44 lanterns hang inside of the arcade, so that most of the yard has only
// the light that walls and vaults pass on. Declare=Bounces=0 leaves that out.
#version 3.7;
#ifndef (Bounces) #declare Bounces = 8; #end
global_settings { assumed_gamma 1 integrator { path_traced { bounces Bounces } } }
#default { finish { ambient 0 diffuse 1 } }
camera {
    location <-5.7, 3.3, -6.6> right 16/9*x angle 74 look_at <0.6, 2.2, 1>
    film { exposure 1.8 response agx glare { veil 0.15 star 0 } }
}
sky_sphere { pigment { rgb <0.0035, 0.005, 0.011> } luminaire }

#declare Plaster = pigment { rgb <0.83, 0.66, 0.46> }
#declare Stone = pigment { rgb <0.6, 0.55, 0.48> }
#declare Terracotta = pigment { rgb <0.62, 0.26, 0.14> }
#declare Half = 7;      // of the yard
#declare Deep = 2.6;    // the arcade
#declare Bay = 2;

// The floor: slabs, darker in the joints, and a border of terracotta.
plane { y, 0 pigment { rgb 0.25 } }
#declare Chance = seed(9);
#for (I, -7, 6)
    #for (J, -7, 6)
        #local Tone = 0.85 + 0.3*rand(Chance);
        #local Border = (max(abs(I + 0.5), abs(J + 0.5)) > 6);
        superellipsoid {
            <0.08, 0.08> scale <0.488, 0.03, 0.488> translate <I + 0.5, 0.005, J + 0.5>
            pigment { rgb Tone*(Border ? <0.5, 0.24, 0.14> : <0.62, 0.55, 0.46>) }
        }
    #end
#end

// One side: a wall with round arches on columns, a vault behind it and windows above.
#declare Arch = union {
    box { <-0.72, -0.1, -1>, <0.72, 2.1, 1> }
    cylinder { <0, 2.1, -1>, <0, 2.1, 1>, 0.72 }
}
#declare Window = union {
    box { <-0.42, 0, -1>, <0.42, 1.1, 1> }
    cylinder { <0, 1.1, -1>, <0, 1.1, 1>, 0.42 }
}
#declare Column = union {
    cylinder { 0.1*y, 2.0*y, 0.17 }
    superellipsoid { <0.2, 0.2> scale <0.26, 0.07, 0.26> translate 0.07*y }
    superellipsoid { <0.2, 0.2> scale <0.27, 0.08, 0.27> translate 2.05*y }
    torus { 0.18, 0.045 translate 0.2*y }
    torus { 0.175, 0.04 translate 1.93*y }
    pigment { Stone }
}
#declare Lantern = union {
    sphere { 0, 0.085 scale <1, 1.35, 1> pigment { rgb <1, 0.62, 0.28> } finish { diffuse 0 emission 22 } }
    cylinder { 0.12*y, 0.16*y, 0.06 pigment { rgb 0.05 } }
    cylinder { 0.16*y, 0.5*y, 0.008 pigment { rgb 0.05 } }
}
#declare Side = union {
    difference {
        box { <-Half - 0.3, 0, Half>, <Half + 0.3, 7.4, Half + 0.34> }
        #for (I, -3, 3)
            object { Arch translate <Bay*I, 0, Half> }
            object { Window translate <Bay*I, 4.35, Half> }
        #end
        pigment { Plaster }
    }
    #for (I, -3, 4)
        object { Column translate <Bay*(I - 0.5), 0, Half - 0.02> }
    #end
    // Mouldings, shutters and a roof of tiles.
    box { <-Half - 0.3, 3.55, Half - 0.1>, <Half + 0.3, 3.72, Half> pigment { Stone } }
    box { <-Half - 0.3, 7.1, Half - 0.14>, <Half + 0.3, 7.3, Half> pigment { Stone } }
    #for (I, -3, 3)
        box { <Bay*I - 0.5, 4.25, Half - 0.09>, <Bay*I + 0.5, 4.33, Half> pigment { Stone } }
        box { <Bay*I - 0.42, 4.33, Half + 0.2>, <Bay*I + 0.42, 5.9, Half + 0.24> pigment { rgb <0.09, 0.16, 0.13> } }
        #for (K, 0, 10)
            box { <Bay*I - 0.4, 4.4 + 0.125*K, Half + 0.17>, <Bay*I + 0.4, 4.47 + 0.125*K, Half + 0.2>
                pigment { rgb <0.12, 0.22, 0.17> } }
        #end
    #end
    #for (I, -24, 24)
        cylinder { <0.3*I, 7.38, Half - 0.35>, <0.3*I, 8.2, Half + 1.6>, 0.12 pigment { Terracotta } }
    #end
    // The back wall of the arcade, its door, and its ceiling in bays.
    box { <-Half - Deep, 0, Half + Deep>, <Half + Deep, 4, Half + Deep + 0.2> pigment { rgb <0.8, 0.42, 0.24> } }
    box { <-Half - Deep, 3.3, Half>, <Half + Deep, 3.5, Half + Deep> pigment { Plaster } }
    #for (I, -3, 4)
        box { <Bay*(I - 0.5) - 0.12, 2.9, Half>, <Bay*(I - 0.5) + 0.12, 3.3, Half + Deep> pigment { Plaster } }
    #end
    #for (I, -5, 5)
        object { Lantern translate <1.25*I, 2.62, Half + 0.6*Deep> }
    #end
}
#for (I, 0, 3) object { Side rotate 90*I*y } #end

// A fountain in the middle.
#declare Basin = union {
    difference {
        cylinder { 0, 0.62*y, 1.75 }
        cylinder { 0.2*y, y, 1.5 }
    }
    torus { 1.63, 0.13 translate 0.62*y }
    lathe {
        bezier_spline 8
        <0.36, 0.2> <0.3, 0.5> <0.16, 0.6> <0.14, 1.15>
        <0.14, 1.15> <0.3, 1.3> <0.75, 1.35> <0.8, 1.55>
    }
    pigment { Stone }
}
object { Basin }
disc {
    0.5*y, y, 1.55
    pigment { rgb <0.02, 0.03, 0.03> }
    normal { ripples 0.12 scale 0.25 }
    finish { diffuse 0.3 reflection { 0.03, 1 fresnel } }
    interior { ior 1.33 }
}

// Lemon trees in pots.
#macro Tree(Seed)
    #local R = seed(Seed);
    union {
        lathe {
            linear_spline 5 <0, 0>, <0.26, 0>, <0.36, 0.52>, <0.4, 0.52>, <0.4, 0.6>
            pigment { Terracotta }
        }
        disc { 0.55*y, y, 0.38 pigment { rgb <0.1, 0.06, 0.04> } }
        cylinder { 0.5*y, 1.3*y, 0.045 pigment { rgb <0.2, 0.13, 0.08> } }
        #for (I, 1, 520)
            #local Way = vnormalize(<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>);
            sphere {
                0, 1 scale <0.085, 0.02, 0.045>
                rotate 360*<rand(R), rand(R), rand(R)>
                translate 1.62*y + (0.35 + 0.3*rand(R))*<Way.x, 0.95*Way.y, Way.z>
                pigment { rgb <0.09 + 0.1*rand(R), 0.2 + 0.12*rand(R), 0.05> }
            }
        #end
        #for (I, 1, 22)
            #local Way = vnormalize(<rand(R) - 0.5, rand(R) - 0.6, rand(R) - 0.5>);
            sphere { 0, 0.055 scale <1, 1.2, 1> translate 1.62*y + 0.62*Way pigment { rgb <0.9, 0.66, 0.06> } }
        #end
    }
#end
#for (I, 0, 3)
    object { Tree(I + 1) rotate 70*I*y translate <3.9, 0.03, 3.9> rotate 90*I*y }
#end
// A bench and a table that were left there.
union {
    box { <-0.9, 0.42, -0.2>, <0.9, 0.48, 0.2> }
    box { <-0.75, 0, -0.16>, <-0.65, 0.42, 0.16> }
    box { <0.65, 0, -0.16>, <0.75, 0.42, 0.16> }
    pigment { rgb <0.34, 0.2, 0.11> }
    rotate 35*y translate <2.9, 0.03, -1.6>
}
