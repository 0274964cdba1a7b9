// SPDX-License-Identifier: GPL-3.0-or-later
// law writing, seed 536353437
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { count 1500 }
    radiosity { recursion_limit 1
        gray_threshold 0.96
        media
        error_bound 1.75
        minimum_reuse 0.01
        maximum_reuse 0.22
    }
    integrator { pov_ray }
    light_sampler { linear_alpha }
    ambient_light rgb <0.52, 0.49, 0.24>
    irid_wavelength rgb <0.22, 0.79, 0.32>
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
    aperture 0.3 blur_samples 16 bokeh { blades 5 angle 20 }
    shutter 1, 2
    film { 
        exposure 0.48
        auto_exposure
        key 0.1
        contrast 1.2
        saturation 0.8
        grain 0.72
        grain_seed 0
    }
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
light_group { 
    light_source { <-1.5, 2.2, -1.5>, rgb 0.6/*light 3*/*<1, 0.9, 0.7> }
    julia_fractal { <-0.083, 0, -0.83, -0.025> hypercomplex pwr <2, 0> max_iteration 2 precision 3 slice <0, 0.1, 0, 1>, 0.1
        texture { 
            pigment { rgb 1 transmit 1 }
            finish { diffuse 0 }
            normal { checker , 0.6
                scale 0.3
            }
        }
        texture { pigment { gradient y color_map { [0 rgb <0.2, 0.3, 0.7>] [0.4 rgb 1 transmit 1] } scale 0.5 } finish { diffuse 0.6 } }
        no_shadow
        hollow
        interior { media { scattering { 5, rgb <0.8, 0.6, 0.4> eccentricity 0.4 } } }
        photons { target on reflection on refraction on }
    }
    global_lights on
    translate <-0.2, 0.9, 0>
}
sor { 5, <0.3, -1>, <0.5, -0.7>, <0.3, 0>, <0.5, 0.6>, <0.2, 1>
    pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission 3/*light 0*/ /*no_luminaire*/ } 
    scale 0.8 translate <-1.3, 2.3, -0.9>
}
light_source { <-2, 3, -2.5>, rgb 0.8/*light 1*/*<1, 0.9, 0.8> flux 20/*light 1*/ spotlight point_at <0, 0.5, 0> radius 20 falloff 30 }
sky_sphere { pigment { rgb <0.6, 0.8, 1> } emission 0.5/*light 2*/ luminaire/*luminaire*/ }
media { scattering { 1, rgb 0.08 multiple } }
meter { "eye" luminance points { 1, <0, 1, -2> } direction <0, -0.1, 1> cone 5 }
meter { "here" daylight_factor corner <-1, 0.5, -1> along 2*x across 2*z en_12464 direction <0.3, -0.1, 1> up y maintenance 0.8 }
