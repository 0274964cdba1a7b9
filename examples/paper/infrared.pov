// SPDX-License-Identifier: CC0-1.0
// A street on a cold night as a thermal camera sees it, at a wavelength of 10 micrometres: nearly
// everything is a luminaire, as the paper says of infrared scenes. What reflects a share of the
// light emits the rest of what a black body of its temperature does (Planck, Kirchhoff).
#version 3.7;
global_settings {
    // A thermal camera shows radiance as it is, from black to white.
    assumed_gamma 2.2
    max_trace_level 12
    integrator { path_traced { bounces 6 } }
}
camera { location <-3.4, 1.7, -9.5> right 16/9*x angle 60 look_at <0.2, 1.95, 0> }

// The radiance of a black body, as a share of what the camera shows as white.
#declare White = 36;
#macro Black_Body(Celsius) (exp(1438.8/(273.15 + White)) - 1)/(exp(1438.8/(273.15 + Celsius)) - 1) #end
#macro Matt(Celsius, Emissivity)
    texture {
        pigment { rgb 1 }
        finish { ambient 0 diffuse 1 - Emissivity emission Emissivity*Black_Body(Celsius) }
    }
#end
#macro Shiny(Celsius, Emissivity)
    texture {
        pigment { rgb 1 }
        finish { ambient 0 diffuse 0 reflection 1 - Emissivity emission Emissivity*Black_Body(Celsius) }
    }
#end
// From one temperature to another along y, from 0 to 1.
#macro Cooling(From, To, Emissivity)
    texture {
        pigment { gradient y color_map { [0 rgb Black_Body(From)] [1 rgb Black_Body(To)] } }
        finish { ambient 0 diffuse 1 - Emissivity emission Emissivity }
    }
#end

// A clear sky is cold overhead and as warm as the air at the horizon.
sky_sphere {
    pigment {
        gradient y
        color_map {
            [0 rgb Black_Body(-4)] [0.15 rgb Black_Body(-18)] [0.4 rgb Black_Body(-35)]
            [1 rgb Black_Body(-55)]
        }
    }
    luminaire
}

// The street, its kerb, and a puddle in which the car is seen.
box { <-3000, -1, -3000>, <3000, 0, 3000> Matt(0, 0.94) }
box { <-30, 0, 2.2>, <30, 0.14, 4.2> Matt(4, 0.92) }
#declare Puddle = union {
    disc { <0, 0.004, 0>, y, 0.85 scale <1.7, 1, 0.8> }
    disc { <0.9, 0.004, 0.4>, y, 0.6 scale <1.8, 1, 0.7> }
    texture {
        pigment { rgb 1 }
        finish { ambient 0 diffuse 0 reflection { 0.02, 0.75 fresnel on } emission 0.75*Black_Body(1) }
    }
    interior { ior 1.33 }
}
object { Puddle translate <-0.9, 0, -2.3> }

// A house: its walls lose little, its windows more, and one is open.
#declare Walls = difference {
    box { <-9, 0, 4.2>, <6.6, 6.4, 5> }
    #for (Floor, 0, 1)
        #for (I, -3, 2)
            #if (!(Floor = 0 & I = 0))
                box { <I*2.4 + 0.3, 1.1 + 3*Floor, 4>, <I*2.4 + 1.5, 2.6 + 3*Floor, 5.1> }
            #end
        #end
    #end
    box { <0.35, 0.1, 4>, <1.45, 2.4, 5.1> }
}
object { Walls Matt(5.5, 0.92) }
#declare Chance = seed(4);
#for (Floor, 0, 1)
    #for (I, -3, 2)
        #if (!(Floor = 0 & I = 0))
            #local Open = (Floor = 1 & I = -1);
            #local Heat = (Open ? 21 : 9 + 6*rand(Chance));
            union {
                // The frame leaks, the pane mirrors the sky a little.
                box { <I*2.4 + 0.3, 1.1 + 3*Floor, 4.42>, <I*2.4 + 1.5, 2.6 + 3*Floor, 4.5>
                    Shiny(Heat, 0.84) }
                box { <I*2.4 + 0.86, 1.1 + 3*Floor, 4.38>, <I*2.4 + 0.94, 2.6 + 3*Floor, 4.42>
                    Matt(Heat - 3, 0.9) }
                // The radiator below the sill warms the wall.
                box { <I*2.4 + 0.4, 0.55 + 3*Floor, 4.19>, <I*2.4 + 1.4, 1.0 + 3*Floor, 4.2>
                    Matt(7.5 + 2*rand(Chance), 0.92) }
            }
        #end
    #end
#end
box { <0.35, 0.1, 4.5>, <1.45, 2.4, 4.6> Matt(10, 0.9) }
box { <0.3, 0.1, 4.44>, <0.36, 2.4, 4.6> Matt(15, 0.9) }
box { <0.35, 0.1, 4.44>, <1.45, 0.17, 4.6> Matt(17, 0.9) }
// A pipe of the heating, a lamp over the door.
cylinder { <-8.2, 0, 4.1>, <-8.2, 6.4, 4.1>, 0.07 Matt(24, 0.9) }
sphere { <0.9, 2.85, 4.05>, 0.11 Matt(70, 0.9) }

// A car that has just come home: engine and exhaust are hot, tyres warm, the body mirrors.
#declare Car = union {
    superellipsoid { <0.35, 0.35> scale <2.05, 0.38, 0.82> translate 0.68*y Shiny(7, 0.55) }
    superellipsoid { <0.5, 0.5> scale <1.15, 0.4, 0.74> translate <0.25, 1.2, 0> Shiny(9, 0.8) }
    // The bonnet over the engine
    superellipsoid { <0.35, 0.35> scale <0.62, 0.05, 0.7> translate <-1.36, 1.03, 0> Matt(46, 0.9) }
    box { <-2.09, 0.5, -0.5>, <-2.04, 0.85, 0.5> Matt(38, 0.9) }
    #for (I, 0, 3)
        union {
            torus { 0.26, 0.09 rotate 90*x Matt(27, 0.95) }
            cylinder { -0.09*z, 0.09*z, 0.22 Matt(44, 0.8) }
            translate <(mod(I, 2) = 0 ? -1.3 : 1.3), 0.34, (I < 2 ? -0.78 : 0.78)>
        }
    #end
    cylinder { <2.0, 0.34, 0.45>, <2.2, 0.34, 0.45>, 0.05 Matt(85, 0.9) }
}
object { Car rotate -6*y translate <1.9, 0, 0.6> }
// The road is warm below it.
disc { <0.8, 0.003, 0.7>, y, 0.55 Matt(9, 0.94) }

// Somebody with a dog.
#declare Person = union {
    sphere { <0, 1.64, 0>, 0.115 scale <1, 1, 1> Matt(31, 0.98) }
    cone { <0, 1.44, 0>, 0.07, <0, 1.56, 0>, 0.065 Matt(30, 0.98) }
    sphere { 0, 0.124 scale <1, 0.7, 1> translate <0.01, 1.71, 0> Matt(13, 0.95) }
    blob {
        threshold 0.5
        cylinder { <0, 0.9, 0>, <0, 1.38, 0>, 0.3, 1 }
        cylinder { <-0.17, 1.36, 0>, <-0.3, 0.98, -0.06>, 0.13, 1 }
        cylinder { <0.17, 1.36, 0>, <0.34, 1.0, -0.12>, 0.13, 1 }
        Matt(15, 0.95)
    }
    sphere { <-0.31, 0.93, -0.07>, 0.055 Matt(27, 0.98) }
    sphere { <0.36, 0.95, -0.14>, 0.055 Matt(27, 0.98) }
    cone { <-0.09, 0.9, 0>, 0.115, <-0.16, 0.12, 0.16>, 0.07 Matt(17, 0.95) }
    cone { <0.09, 0.9, 0>, 0.115, <0.16, 0.12, -0.18>, 0.07 Matt(17, 0.95) }
    sphere { 0, 1 scale <0.07, 0.055, 0.14> translate <-0.16, 0.06, 0.1> Matt(9, 0.95) }
    sphere { 0, 1 scale <0.07, 0.055, 0.14> translate <0.16, 0.06, -0.24> Matt(9, 0.95) }
}
object { Person rotate 78*y translate <-3.35, 0.0, -0.6> }
#declare Dog = union {
    blob {
        threshold 0.45
        cylinder { <-0.3, 0.42, 0>, <0.26, 0.44, 0>, 0.22, 1 }
        cylinder { <0.28, 0.46, 0>, <0.42, 0.6, 0>, 0.14, 1 }
        Matt(23, 0.97)
    }
    sphere { 0, 1 scale <0.13, 0.09, 0.085> translate <0.5, 0.64, 0> Matt(28, 0.97) }
    sphere { <0.62, 0.63, 0>, 0.025 Matt(14, 0.97) }
    #for (I, 0, 3)
        cone { <(I < 2 ? -0.28 : 0.24), 0.4, (mod(I, 2) - 0.5)*0.16>, 0.06,
               <(I < 2 ? -0.33 : 0.27) + 0.05*mod(I, 2), 0, (mod(I, 2) - 0.5)*0.16>, 0.03 Matt(19, 0.97) }
    #end
    cone { <-0.42, 0.5, 0>, 0.03, <-0.58, 0.66, 0>, 0.015 Matt(18, 0.97) }
}
object { Dog translate <-2.35, 0, -0.85> }

// A lamp post: the pole is cold, what it carries is not.
cylinder { <-5.2, 0, 1.9>, <-5.2, 5, 1.9>, 0.07 Shiny(1, 0.6) }
superellipsoid { <0.4, 0.4> scale <0.4, 0.09, 0.16> translate <-4.95, 5.05, 1.9> Matt(34, 0.9) }
// A cup that somebody left on the kerb, still hot at its bottom.
cone { 0, 0.035, 0.13*y, 0.047 open Cooling(52, 38, 0.95) scale 1.6 translate <-4.4, 0.14, 2.35> }
