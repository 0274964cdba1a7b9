// SPDX-License-Identifier: GPL-3.0-or-later
// law reflected, seed 3900941791
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1
    photons { count 3000 }
    radiosity { recursion_limit 1 }
    integrator { pov_ray }
    light_sampler { linear_alpha }
    index { bounding_boxes node_cost 1.24 }
}
camera { user_defined location { function { x/9 } function { 1 + y/9 } function { -4 } } direction { function { x } function { y - 0.1*x*x } function { 1 } }
    location <0, 2.2, -5>
    look_at <0, 0.7, 0>
    shutter 1, 2
    film { 
        pixel_filter mitchell smooth_edges
    }
}
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
intersection { 
    cone { <0, -0.7, 0>, 0.7, <0, 0.7, 0>, 0.25
        open
        texture { 
            pigment { rgb 1 transmit 1 }
            finish { diffuse 0 }
            normal { hexagon , 0.4
                scale 0.3
            }
            rotate 40*z scale 0.7 translate 0.2
        }
        interior_texture { pigment { rgb 0.1 } finish { diffuse 0.5 } }
        hollow
        interior { media { scattering { 2, rgb <0.8, 0.6, 0.4> } } }
        photons { collect on pass_through }
    }
    box { <-0.5, -0.5, -0.6>, <0.5, 0.6, 0.5> }
    
    translate <-0.2, 0.9, 0>
}
sphere { 0, 0.9 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } interior { media { emission 2/*light 0*/ absorption 0.3 } luminaire/*luminaire*/ } clipped_by { plane { -y, 0 } } scale 0.8 translate <-1.3, 2.3, -0.9>  }
light_source { <-2, 3, -2.5>, rgb 0.8/*light 1*/*<1, 0.9, 0.8> spotlight point_at <0, 0.5, 0> radius 12 falloff 20 tightness 5 }
media { absorption 0.3 density { bozo color_map { [0.4 rgb 0] [0.6 rgb 1] } scale 0.6 } }
box { <-1.7, 0, 0.9>, <1.9, 1.9, 1.1> pigment { rgb 0.9 } finish { diffuse 1 } }
box { <-1.9, 0, -1.2>, <-1.7, 1.9, 1.1> pigment { rgb 0.9 } finish { diffuse 1 } }
