// SPDX-License-Identifier: GPL-3.0-or-later
// law adaptive, seed 1663289236
// option shadow_rays 2
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { spacing 0.05 }
    radiosity { recursion_limit 2 }
    integrator { path_traced }
    light_sampler { every_light }
    index { kd_tree }
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
    sky <0.3, 1, 0> right 1.2*x
    shutter 0.5, 3
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -0.3 clipped_by { box { -0.9, 0.9 } }
    material { 
        texture { 
            pigment { rgb 1 transmit 1 }
            finish { diffuse 0 }
            normal { checker , 0.7
                accuracy 0.05
                scale 0.3
            }
        }
    }
    no_shadow
    interior_texture { pigment { rgb 1 } finish { diffuse 0.1 reflection 0.7 } }
    hollow
    interior { media { absorption <0.5, 1, 1.5> } }
    photons { target 1 refraction on collect off }
    scale <-1, 1, 1>
    translate <-0.2, 0.9, 0>
}
sphere { 0, 0.6 pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission 3/*light 0*/ /*no_luminaire*/ } scale 0.8 translate <-1.3, 2.3, -0.9> translate clock*x }
light_source { <-2, 3, -2.5>, rgb 0.8/*light 1*/*<1, 0.9, 0.8> flux 20/*light 1*/ spotlight point_at <0, 0.5, 0> radius 20 falloff 30 }
background { rgb 0.3/*light 2*/*<0.6, 0.8, 1> }
media { absorption <0.05, 0.1, 0.15> }
meter { "eye" luminance points { 1, <0, 1, -2> } direction <0, -0.1, 1> cone 5 }
meter { "here" illuminance points { 2, <0.5, 1, 0>, <-1, 0.2, 1> } direction <0.3, -0.1, 1> up y maintenance 0.8 }
