// SPDX-License-Identifier: CC0-1.0
// A glass of water on a table, under a string of 11 small lamps. `photons` shows the light that glass and water gather:
// without it the glass only throws shadows.
#version 3.7;
global_settings {
    assumed_gamma 1
    max_trace_level 12
    photons { count 60000 }
}
#default { finish { ambient 0 } }

camera { location <0.2, 3.4, -5.4> right 4/3*x angle 36 look_at <0, 0.5, -0.6> }

// The table, of boards.
plane {
    y, 0
    pigment {
        wood
        turbulence 0.06
        color_map { [0 rgb <0.75, 0.6, 0.42>] [1 rgb <0.62, 0.46, 0.3>] }
        scale <0.3, 0.3, 6>
        rotate <2, 68, 0>
        translate <0.6, -1.2, 0>
    }
    finish { diffuse 0.8 specular 0.1 roughness 0.06 }
}

// Walls of the glass, and the water, which reaches a little way into them.
#declare Clear = finish { diffuse 0 specular 0.4 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy }
#declare Outside = cone { <0, 0, 0>, 0.42, <0, 1.5, 0>, 0.56 }
difference {
    object { Outside }
    cone { <0, 0.14, 0>, 0.37, <0, 1.6, 0>, 0.525 }
    pigment { rgbt 1 }
    finish { Clear }
    interior { ior 1.5 }
    photons { target reflection on refraction on collect off }
}
cone {
    <0, 0.139, 0>, 0.372, <0, 1.05, 0>, 0.4705
    pigment { rgbf <0.93, 0.98, 1, 1> }
    finish { Clear }
    interior { ior 1.33 }
    photons { target reflection on refraction on collect off }
}

// The string hangs behind the glass, out of sight.
#declare Colours = array[3] { <1, 0.6, 0.25>, <1, 0.8, 0.5>, <0.75, 0.85, 1> };
#declare Lamps = 11;
#for (I, 0, Lamps - 1)
    #local Along = I/(Lamps - 1)*2 - 1;
    sphere {
        <2.4*Along - 0.3, 2.1 + 0.5*Along*Along, 3 - 0.9*Along*Along>, 0.03
        pigment { rgb 1 }
        finish { diffuse 0 emission 1500*Colours[mod(I, 3)] }
    }
#end
