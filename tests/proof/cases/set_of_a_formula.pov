// SPDX-License-Identifier: GPL-3.0-or-later
// law strategies, seed 3139075276
// option jitter 0
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { spacing 0.05 }
    radiosity { recursion_limit 1
        normal
        adc_bailout 0.02
        subsurface
    }
    integrator { pov_ray }
    light_sampler { light_octree }
    index { kd_tree group_cost 0.59 }
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
    sky <0.3, 1, 0> right 1.2*x
    film { 
        pixel_filter mitchell smooth_edges
    }
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -0.5> clipped_by { box { -0.9, 0.9 } }
    texture { 
        tiles { 
            texture { 
                pigment { rgb 1 transmit 1 }
                finish { diffuse 0 }
                normal { triangular , 0.2
                    scale 0.3
                }
            }
            tile2
            texture { pigment { rgb 0.6 } finish { diffuse 0.6 } }
        }
    }
    double_illuminate
    interior_texture { pigment { rgb 0.1 } finish { diffuse 0.5 } }
    hollow
    interior { media { scattering { 4, rgb <0.8, 0.6, 0.4> } } }
    photons { target 1 refraction on collect off }
    scale <-1, 1, 1>
    translate <-0.2, 0.9, 0>
}
julia_fractal { <-0.083, 0, -0.83, -0.025> hypercomplex cosh max_iteration 2 precision 3 
    pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission 3/*light 0*/ /*no_luminaire*/ } 
    scale 0.8 translate <-1.3, 2.3, -0.9>
}
light_source { <-2, 3, -2.5>, rgb 0.8/*light 1*/*<1, 0.9, 0.8> intensity 9/*light 1*/ }
sky_luminance { partly_cloudy sun <40, 30> zenith 0.3/*light 2*/ direct 0.4/*light 2*/ ground 0.3 north z up y temperature 6000 }
fog { rgb 0 distance 8 }
meter { "eye" luminance points { 1, <0, 1, -2> } direction <0, -0.1, 1> cone 5 }
meter { "here" spherical corner <-1, 0.5, -1> along 2*x across 2*z en_12464 direction <0.3, -0.1, 1> up y maintenance 0.8 }
