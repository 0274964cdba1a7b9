// SPDX-License-Identifier: GPL-3.0-or-later
// law strategies, seed 3450481982
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { count 1200 }
    integrator { path_traced bounces 2 reflected_luminaires 0 }
    light_sampler { light_octree }
    index { bounding_boxes node_cost 0.99 }
    max_trace_level 12 adc_bailout 0.001
}
camera { perspective
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    angle 45
    normal { bumps 0.2 scale 0.3 }
    shutter 0.5, 3
    film { 
        exposure 1 white_balance 5000 response filmic
        glare { veil 0.2 halo 0.03 star 0.1 blades 6 length 2 field 40 }
    }
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 2 precision 3 
    texture { 
        pigment { rgb <0.6, 0.9, 0.7> filter 0.4 transmit 0.4 }
        finish { diffuse 0.6
            conserve_energy
        }
        normal { ripples , 0.8
            scale 0.3
        }
    }
    no_radiosity
    interior_texture { pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0.3 emission 2/*light 0*/ /*no_luminaire*/ } }
    interior { ior 1.5 }
    photons { collect on pass_through }
    rotate <20, 130, -35>
    translate <-0.2, 0.9, 0>
}
sor { 5, <0.3, -1>, <0.5, -0.7>, <0.3, 0>, <0.5, 0.6>, <0.2, 1>
    pigment { rgb <1, 0.8, 0.6> } finish { diffuse 0 emission 3/*light 1*/ /*no_luminaire*/ } 
    scale 0.8 translate <-1.3, 2.3, -0.9>
}
