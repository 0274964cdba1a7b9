// SPDX-License-Identifier: CC0-1.0
// A room of 6 by 4 metres lit by lamps as their data sheets have them: six panels of 3600 lm by a
// file of EULUMDAT, three spots on the back wall by a file of IES LM-63, and a table lamp of 470 lm at
// 2700 K. The panels are surfaces, which glow by direction as the file says; the spots are points.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    photometry { unit 1 white 200 }   // metres; a radiance of 1 is 200 cd/m2
    integrator { path_traced bounces 4 }
}
#default { finish { ambient 0 diffuse 1 } }

camera {
    location <-2.6, 1.6, -1.7>
    right 4/3*x up y angle 76
    look_at <0.8, 1.15, 0.7>
    film { exposure auto }
}

// floor, ceiling, walls
box { <-3, -0.1, -2>, <3, 0, 2> pigment { rgb <0.22, 0.17, 0.12> } }
box { <-3, 2.8, -2>, <3, 2.9, 2> pigment { rgb 0.8 } }
#declare Wall = texture { pigment { rgb <0.62, 0.6, 0.56> } }
box { <-3.1, 0, -2>, <-3, 2.8, 2> texture { Wall } }
box { <3, 0, -2>, <3.1, 2.8, 2> texture { Wall } }
box { <-3, 0, -2.1>, <3, 2.8, -2> texture { Wall } }
box { <-3, 0, 2>, <3, 2.8, 2.1> texture { Wall } }

// C0 of the file lies along the room; what is light in it leads straight down as it stands.
#declare Panel = box {
    <-0.29, -0.005, -0.29>, <0.29, 0.005, 0.29>
    pigment { rgb 1 }
    finish { luminaire { ldt "panel.ldt" temperature 4000 } }
}
#for (I, -1, 1)
    object { Panel translate <1.9*I, 2.79, -0.9> }
    object { Panel translate <1.9*I, 2.79, 0.9> }
    light_source { <1.9*I, 2.7, 1.6>, rgb kelvin(3000) ies "spot.ies" aim <0, -1, 0.22> c0 x }
#end

// table, things on it, and a lamp
box { <-0.2, 0.71, -0.4>, <1.6, 0.74, 0.6> pigment { rgb <0.5, 0.36, 0.22> } }
#for (I, 0, 3)
    cylinder { <-0.12 + 1.64*mod(I, 2), 0, -0.32 + 0.84*int(I/2)>,
               <-0.12 + 1.64*mod(I, 2), 0.71, -0.32 + 0.84*int(I/2)>, 0.03 pigment { rgb 0.1 } }
#end
sphere { <0.3, 0.84, 0.1>, 0.1 pigment { rgb <0.7, 0.2, 0.15> } }
box { <0.55, 0.74, -0.15>, <0.85, 0.79, 0.1> pigment { rgb <0.2, 0.35, 0.5> } }
cylinder { <1.2, 0.74, 0.3>, <1.2, 1.0, 0.3>, 0.015 pigment { rgb 0.15 } }
sphere { <1.2, 1.05, 0.3>, 0.06 pigment { rgb 1 } luminaire { flux lumen(470) temperature 2700 } }
