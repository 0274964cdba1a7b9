// SPDX-License-Identifier: CC0-1.0
// An office of 7.2 by 5.4 metres with eight suspended lamps of 4000 lm, at dusk. The meters ask what EN 12464-1 asks: 500 lx
// on the desks with a uniformity of 0.6, 150 lx on faces, and glare of no more than 19, which bare lamps exceed a little.
//   candelabra office.pov --measure office.csv
//   candelabra office.pov +Ooffice.exr --layers illuminance,luminance
//   candelabra develop office.exr --false-colour lux --isolines -o office_lux.png
#version 3.7;
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 200 }
    integrator { path_traced bounces 6 }
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location <0.45, 1.75, 0.4>
    right 16/9*x up y angle 84
    look_at <4.6, 0.95, 3.6>
    film { exposure auto response agx }
}
background { rgb <0.012, 0.02, 0.045> }

#declare Long = 7.2; #declare Deep = 5.4; #declare High = 2.8;

// ---- the room; the far wall has windows
#declare Wall = texture { pigment { rgb <0.72, 0.71, 0.68> } }
box { <0, -0.1, 0>, <Long, 0, Deep> pigment { rgb <0.2, 0.21, 0.23> } }
box { <0, High, 0>, <Long, High + 0.1, Deep> pigment { rgb 0.82 } }
box { <-0.1, 0, 0>, <0, High, Deep> texture { Wall } }
box { <Long, 0, 0>, <Long + 0.1, High, Deep> pigment { rgb <0.26, 0.4, 0.42> } }
box { <0, 0, -0.1>, <Long, High, 0> texture { Wall } }
box { <0, 0, Deep>, <Long, 0.9, Deep + 0.2> texture { Wall } }
box { <0, 2.45, Deep>, <Long, High, Deep + 0.2> texture { Wall } }
#for (I, 0, 4)
    box { <1.8*I - 0.06, 0.9, Deep>, <1.8*I + 0.06, 2.45, Deep + 0.2> texture { Wall } }
#end
box { <0, 0.88, Deep - 0.12>, <Long, 0.91, Deep + 0.05> pigment { rgb 0.75 } }
// the town outside
#declare Stream = seed(11);
#for (I, 0, 13)
    #declare House = <-6 + 1.6*I, 0, 24 + 9*rand(Stream)>;
    #declare Top = 1 + 5*rand(Stream);
    box { House + <0, -8, 0>, House + <1.5, Top, 3> pigment { rgb 0.05 } }
    #for (K, 0, 30)
        #if (rand(Stream) < 0.35)
            box { <0, 0, -0.02>, <0.22, 0.32, -0.01>
                translate House + <0.15 + 0.32*mod(K, 4), -3.2 + 0.55*int(K/4), 0>
                pigment { rgb kelvin(2700 + 1500*rand(Stream)) }
                finish { diffuse 0 emission 0.12 + 0.3*rand(Stream) no_luminaire }
            }
        #end
    #end
#end

// ---- furniture
#declare Wood = texture { pigment { rgb <0.55, 0.4, 0.25> } }
#declare Steel = texture { pigment { rgb 0.18 } }
#declare Desk = union {
    box { <-0.8, 0.72, -0.4>, <0.8, 0.745, 0.4> texture { Wood } }
    #for (I, 0, 3)
        box { <-0.02, 0, -0.02>, <0.02, 0.72, 0.02> translate <(mod(I, 2) - 0.5)*1.48, 0, (int(I/2) - 0.5)*0.7> texture { Steel } }
    #end
    // screen, keyboard, paper, a mug
    box { <-0.31, 0.86, 0.16>, <0.31, 1.22, 0.18> pigment { rgb 0.03 } }
    box { <-0.3, 0.87, 0.158>, <0.3, 1.21, 0.16> pigment { rgb <0.6, 0.75, 1> } finish { diffuse 0 emission 0.35 } }
    cylinder { <0, 0.745, 0.22>, <0, 0.95, 0.2>, 0.025 texture { Steel } }
    box { <-0.1, 0.745, 0.14>, <0.1, 0.755, 0.3> texture { Steel } }
    box { <-0.2, 0.745, -0.16>, <0.2, 0.757, -0.04> pigment { rgb 0.1 } }
    box { <-0.105, 0.745, -0.15>, <0.105, 0.748, 0.15> rotate 12*y translate <0.5, 0, -0.1> pigment { rgb 0.85 } }
    cylinder { <-0.5, 0.745, 0>, <-0.5, 0.84, 0>, 0.04 pigment { rgb <0.75, 0.25, 0.15> } }
}
#declare Chair = union {
    superellipsoid { <0.3, 0.3> scale <0.24, 0.04, 0.23> translate 0.47*y }
    superellipsoid { <0.3, 0.3> scale <0.22, 0.26, 0.03> rotate -8*x translate <0, 0.8, -0.22> }
    cylinder { 0.06*y, 0.45*y, 0.03 }
    #for (I, 0, 4) cylinder { 0.06*y, <0.28, 0.04, 0>, 0.02 rotate 72*I*y } #end
    pigment { rgb <0.12, 0.16, 0.2> }
}
#declare Places = array[4] { <2.1, 0, 1.6>, <4.2, 0, 1.6>, <2.1, 0, 3.4>, <4.2, 0, 3.4> };
#for (I, 0, 3)
    object { Desk rotate 180*(I >= 2)*y translate Places[I] + <0, 0, (I < 2 ? 0.45 : -0.45)> }
    object { Chair rotate (180*(I >= 2) + 25*(I = 1))*y translate Places[I] + <0.05, 0, (I < 2 ? -0.2 : 0.25)> }
#end
box { <1.3, 0.745, 2.49>, <5, 1.2, 2.51> pigment { rgb <0.3, 0.42, 0.36> } }
// shelves with folders before the far right wall
#declare Shelf = union {
    #for (K, 0, 4) box { <-0.35, 0.42*K, -1.2>, <0, 0.42*K + 0.02, 1.2> } #end
    #for (K, 0, 2) box { <-0.35, 0, 1.19*(K - 1) - 0.01>, <0, 1.7, 1.19*(K - 1) + 0.01> } #end
    pigment { rgb <0.62, 0.5, 0.36> }
}
object { Shelf translate <Long, 0, 1.6> }
#for (K, 0, 3)
    #for (I, 0, 25)
        #if (rand(Stream) < 0.8)
            box { <-0.28, 0, 0>, <-0.03, 0.26 + 0.08*rand(Stream), 0.065>
                translate <Long, 0.42*K + 0.02, 0.45 + 0.085*I>
                pigment { rgb <0.25 + 0.6*rand(Stream), 0.25 + 0.4*rand(Stream), 0.25 + 0.35*rand(Stream)> }
            }
        #end
    #end
#end
// a plant
cone { <6.6, 0, 4.7>, 0.16, <6.6, 0.4, 4.7>, 0.22 pigment { rgb <0.75, 0.72, 0.66> } }
#for (I, 0, 90)
    sphere { 0, 1 scale <0.2, 0.012, 0.05> translate 0.2*x rotate (15 + 65*rand(Stream))*z rotate 137.5*I*y
        translate <6.6, 0.4 + 0.9*rand(Stream), 4.7> pigment { rgb <0.08, 0.22 + 0.1*rand(Stream), 0.07> } }
#end

// ---- the lamps: bars on two wires, which light up and down
#declare Lamp = union {
    box { <-0.74, -0.03, -0.03>, <0.74, 0.025, 0.03>
        pigment { rgb 1 }
        finish { diffuse 0.8 luminaire { flux lumen(4000) temperature 4000 } }
    }
    box { <-0.75, -0.02, -0.036>, <0.75, 0.02, -0.032> pigment { rgb 0.85 } }
    box { <-0.75, -0.02, 0.032>, <0.75, 0.02, 0.036> pigment { rgb 0.85 } }
    cylinder { -0.6*x, <-0.6, 0.45, 0>, 0.001 pigment { rgb 0.25 } }
    cylinder { 0.6*x, <0.6, 0.45, 0>, 0.001 pigment { rgb 0.25 } }
}
#for (I, 0, 7)
    object { Lamp translate <1.35 + 1.5*mod(I, 4), 2.35, 1.45 + 2.15*int(I/4)> }
#end

// ---- what is measured
#for (I, 0, 3)
    #declare Front = Places[I] + <0, 0.76, (I < 2 ? 0.22 : -0.22)>;
    meter { concat("desk ", str(I + 1, 0, 0)) corner Front - <0.7, 0, 0.15> along 1.4*x across 0.3*z }
#end
meter { "faces" cylindrical corner <0.5, 1.2, 0.5> along <Long - 1, 0, 0> across <0, 0, Deep - 1> counts <7, 5> }
meter { "glare along" ugr points { 1, <0.6, 1.2, 2.5> } direction x }
meter { "glare across" ugr points { 1, <3.2, 1.2, 0.5> } direction z }
