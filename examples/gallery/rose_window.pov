// SPDX-License-Identifier: CC0-1.0
// Sunlight through a rose window: the glass colours beams in the dust of a dark nave.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }

camera {
    location <1.6, 1.9, -10.6>
    right 4/3*x
    up y
    angle 60
    look_at <-0.7, 3.9, 2>
}

// The sun stands behind the window, and a little of the sky shines in beside it.
light_source { <620, 1000, 1500>, rgb <1, 0.86, 0.64>*11 media_attenuation on }
light_source { <-2, 9, -9>, rgb <0.2, 0.23, 0.3> media_interaction off }

#declare Stone = texture {
    pigment { granite scale 0.6 color_map { [0 rgb <0.36, 0.33, 0.3>] [1 rgb <0.5, 0.47, 0.42>] } }
    normal { granite 0.06 scale 0.4 }
    finish { ambient 0 diffuse 0.85 }
}

// Panes of coloured glass in a disc, with lead between them
#declare Wide = 2.6;
#declare Middle = <0.4, 5.2, 6>;
#macro Pane(Inner, Outer, From, To, Tint)
    intersection {
        difference {
            cylinder { -0.02*z, 0.02*z, Outer }
            cylinder { -0.1*z, 0.1*z, Inner }
        }
        plane { -x, 0 rotate From*z }
        plane { x, 0 rotate To*z }
        pigment { rgbf <Tint.x, Tint.y, Tint.z, 0.97> }
        finish { ambient 0 diffuse 0.1 }
    }
#end
#declare Glass = array[6] {
    <1, 0.12, 0.07>, <0.1, 0.25, 1>, <1, 0.62, 0.08>, <0.12, 0.7, 0.3>, <0.65, 0.14, 0.9>,
    <0.2, 0.75, 1>
}
#declare Window = union {
    #for (I, 0, 11)
        object { Pane(0.62, 1.45, 30*I + 2, 30*I + 28, Glass[mod(I, 2)]) }
        object { Pane(1.52, Wide - 0.06, 30*I + 16.5, 30*I + 43.5, Glass[mod(I, 4) + 2]) }
    #end
    cylinder { -0.02*z, 0.02*z, 0.56 pigment { rgbf <1, 0.8, 0.3, 0.97> } finish { diffuse 0.1 } }
}
object { Window translate Middle }

// The wall around it, with the lead as what is left
difference {
    box { <-9, -1, 5.7>, <9, 12, 6.3> }
    cylinder { <Middle.x, Middle.y, 5>, <Middle.x, Middle.y, 7>, Wide }
    texture { Stone }
}
#for (I, 0, 11)
    box {
        <-0.035, 0.55, -0.06>, <0.035, Wide, 0.06>
        rotate 30*I*z
        translate Middle
        texture { Stone }
    }
#end
#declare Rings = array[3] { 0.59, 1.485, Wide - 0.03 }
#for (I, 0, 2)
    torus {
        Rings[I], 0.045
        rotate 90*x
        translate Middle
        texture { Stone }
    }
#end

// The nave: floor, pillars, and the dust in its air
box {
    <-9, -1, -12>, <9, 0, 6>
    pigment { checker rgb 0.22 rgb 0.34 scale 0.9 }
    finish { ambient 0 diffuse 0.8 reflection 0.04 }
}
box { <6, -1, -12>, <7, 12, 6> texture { Stone } }
box { <-9, 11.5, -13>, <9, 12, 6.3> texture { Stone } }
box { <-9, -1, -13>, <9, 12, -12> texture { Stone } }
box { <-8, -1, -12>, <-7, 12, 6> texture { Stone } }
#for (I, 0, 2)
    #for (Side, -1, 1, 2)
        union {
            cylinder { 0, 10*y, 0.42 }
            box { <-0.6, 0, -0.6>, <0.6, 0.35, 0.6> }
            torus { 0.44, 0.1 translate 0.4*y }
            texture { Stone }
            translate <Side*4.6, 0, -4 + 3.6*I>
        }
    #end
#end
box {
    <-7.5, -0.5, -12.5>, <6.5, 11.8, 5.9>
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 }
    hollow
    interior { media { scattering { 5, rgb 0.011 eccentricity 0.25 extinction 1 } samples 16 } }
}
