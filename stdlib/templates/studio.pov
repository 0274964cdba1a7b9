// SPDX-License-Identifier: CC0-1.0
// A studio for one thing: a soft light, a rim light, and a backdrop without an edge.
//   candelabra studio.pov +W960 +H720
#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced bounces 3 } }
#default { finish { ambient 0 diffuse 0.8 } }

camera {
    location <0.6, 1.5, -5> look_at <0, 0.62, 0> angle 32
    right x*image_width/image_height  // the shape of the picture
    aperture 0.08 blur_samples 16 focal_point <0, 0.7, -0.4>
    film {
        exposure 0.4           // in stops; or auto, by the picture itself
        white_balance 5500     // the temperature of light that looks white
        response filmic        // how bright light fades into white
        vignette 0.2
        glare { veil 0.05 halo 0.003 }
    }
}

// The backdrop: a floor that turns into a wall.
union {
    box { <-6, -0.1, -6>, <6, 0, 2> }
    box { <-6, 1, 3>, <6, 6, 3.1> }
    difference {
        box { <-6, -0.1, 2>, <6, 1, 3.1> }
        cylinder { <-6.1, 1, 2>, <6.1, 1, 2>, 1 }
    }
    pigment { rgb <0.5, 0.52, 0.55> }
}

// A large soft light from the left, a small warm one from behind, a dark panel on the right.
#macro Softbox(Width, Height, Radiance)
    box { <-Width/2, -Height/2, 0>, <Width/2, Height/2, 0.02>
        pigment { rgb 1 }
        finish { diffuse 0 emission Radiance }
    }
#end
object { Softbox(2, 2.4, <1, 0.97, 0.92>*9) rotate 52*y rotate 0*x translate <-3.4, 2.6, -2.6> }
object { Softbox(0.5, 1.6, <1, 0.6, 0.3>*28) rotate -140*y translate <2.4, 1.9, 1.8> }
box { <2.6, 0, -3>, <2.65, 3, 0.5> pigment { rgb 0.02 } }

// What you like to show.
union {
    sphere { <0, 0.7, 0>, 0.55 }
    torus { 0.42, 0.1 translate 0.1*y }
    cylinder { 0, <0, 0.3, 0>, 0.2 }
    pigment { rgb <0.75, 0.14, 0.08> }
    finish { microfacet { roughness 0.2 coat 1 } }
}
sphere { <-0.95, 0.3, -0.5>, 0.3 pigment { rgb <0.95, 0.75, 0.4> } finish { microfacet { roughness 0.25 metallic 1 } } }
sphere { <0.85, 0.22, -0.75>, 0.22 pigment { rgb <0.15, 0.3, 0.45> } finish { microfacet { roughness 0.5 } } }
