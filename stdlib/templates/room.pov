// SPDX-License-Identifier: CC0-1.0
// A room in the evening: one lamp, light through a window, and everything that they send on.
//   candelabra room.pov +W960 +H720
#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced bounces 4 } }
#default { finish { ambient 0 diffuse 0.8 } }

camera {
    location <0, 1.5, -3.4> look_at <0, 1.2, 0> angle 75
    right x*image_width/image_height  // the shape of the picture
    film {
        exposure 2.2           // in stops; or auto, by the picture itself
        white_balance 4200     // the temperature of light that looks white
        response agx           // how bright light fades into white
        vignette 0.2
        glare { veil 0.08 halo 0.003 }
    }
}

#declare Plaster = texture { pigment { rgb <0.8, 0.76, 0.7> } }
#declare Wood = texture {
    pigment { wood color_map { [0 rgb <0.45, 0.28, 0.16>] [1 rgb <0.3, 0.17, 0.09>] } turbulence 0.08 scale 0.12 rotate 88*x }
    finish { microfacet { roughness 0.35 } }
}

// Walls, floor and ceiling, with a window on the right.
difference {
    box { <-2.6, -0.1, -4>, <2.6, 2.7, 2.6> }
    box { <-2.5, 0, -3.9>, <2.5, 2.6, 2.5> }
    box { <2.4, 0.9, -0.6>, <2.7, 2.1, 1.2> }
    texture { Plaster }
}
box { <-2.5, 0, -3.9>, <2.5, 0.01, 2.5> texture { Wood } }
box { <2.62, 0.8, -0.8>, <2.64, 2.2, 1.4> pigment { rgb 1 } finish { diffuse 0 emission <0.25, 0.45, 1>*0.35 } }

// A table, and a lamp with a shade on it.
union {
    cylinder { <0, 0.72, 0>, <0, 0.76, 0>, 0.55 }
    #for (I, 0, 2) cylinder { <0.4, 0, 0>, <0.32, 0.72, 0>, 0.03 rotate 120*I*y } #end
    texture { Wood }
    translate <-0.9, 0, 0.6>
}
union {
    sphere { <0, 0.3, 0>, 0.08 pigment { rgb 1 } finish { emission <1, 0.65, 0.3>*60 diffuse 0 } }
    cone { <0, 0.18, 0>, 0.22, <0, 0.42, 0>, 0.13 open pigment { rgb <0.95, 0.85, 0.65> } finish { diffuse 0.45, 0.45 } }
    cylinder { 0, <0, 0.26, 0>, 0.02 }
    cylinder { 0, <0, 0.02, 0>, 0.1 }
    pigment { rgb <0.6, 0.45, 0.2> }
    finish { microfacet { roughness 0.25 metallic 1 } }
    translate <-0.9, 0.76, 0.6>
}

// What you like to show.
sphere { <0.75, 0.45, 0.3>, 0.45 pigment { rgb <0.7, 0.12, 0.1> } finish { microfacet { roughness 0.3 coat 1 } } }
box { <-0.3, 0, -0.3>, <0.3, 0.6, 0.3> rotate 25*y translate <1.6, 0, 1.5> pigment { rgb <0.2, 0.4, 0.35> } }
