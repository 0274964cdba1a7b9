// SPDX-License-Identifier: GPL-3.0-or-later
// Glow whose colour depends on how the surface faces lit nothing.
// law furnace, seed 1205999699
#version 3.7;
#default { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
global_settings { assumed_gamma 1 max_trace_level 50 adc_bailout 0
    integrator { path_traced bounces 50 reflected_luminaires 300 }
}
camera { location <0.3, 0.9, -2.8> look_at 0 angle 40 }
background { rgb 1 }
difference { box { <-0.6, -0.6, -0.5>, 0.6 }
    model { file "gems.gltf" part "Pair" replace "Painted" texture { pigment { rgb 0.6 } }
        texture { pigment { checker rgb 1, rgb 0.9 } finish { diffuse 0.7 } }
        texture { 
            pigment { slope <0.3, 1, 0.2>
                color_map { [0 rgb 1] [1 rgb 1 transmit 0.5] }
            }
        }
    }
}
