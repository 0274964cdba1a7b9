// SPDX-License-Identifier: CC0-1.0
// Three sphereflakes on a polished floor at night. Two of them glow, in 14,742 balls, and light
// the porcelain flake that stands between them: warm from the right, cold from the left. The lens
// adds its glare.
#version 3.7;
#include "sphereflake.inc"
global_settings { assumed_gamma 1.0 max_trace_level 5 }

camera {
    location <-0.3, 1.5, -9.6>
    right 16/9*x
    up y
    angle 47
    look_at <0, 1.3, 0>
    film {
        exposure 1.4
        response filmic
        vignette 0.25
        glare { veil 0.08 halo 0.004 star 0.02 blades 6 angle 8 length 0.3 }
    }
}
sky_sphere {
    pigment {
        gradient y
        color_map { [0 rgb <0.007, 0.01, 0.024>] [0.3 rgb <0.0006, 0.001, 0.003>] }
    }
}

// Sphereflake_Of repeats one ball of each size, the biggest first, with its z outwards: so sparks
// are brightest at their tips
#macro Ball(Colour, Shine)
    sphere {
        0, 1
        pigment { rgb Colour }
        finish { ambient 0 diffuse 0.9 specular 0.3 roughness 0.02 reflection Shine }
    }
#end
#macro Spark(Colour)
    sphere {
        0, 1
        pigment {
            gradient z
            color_map { [0 rgb Colour*0.12] [0.5 rgb Colour*0.6] [1 rgb Colour*1.8] }
            scale 2
            translate -z
        }
        finish { ambient 0 diffuse 0 emission 1 }
    }
#end
#macro Glowing_Flake(Body, Ember, Flame, Spark_Colour)
    Sphereflake_Of(array[5] {
        Ball(Body, 0.1), Ball(Body, 0.1), Spark(Ember), Spark(Flame), Spark(Spark_Colour)
    })
#end
#declare White = Ball(<0.86, 0.85, 0.83>, 0.06);
#declare Porcelain = Sphereflake_Of(array[5] { White, White, White, White, White })

object {
    Glowing_Flake(<0.6, 0.2, 0.1>, <2.4, 0.15, 0.02>, <4.5, 0.6, 0.06>, <6, 1.7, 0.2>)
    rotate <-90, 20, 0>
    scale 0.9
    translate <2.55, 0.9, -0.9>
}
object {
    Glowing_Flake(<0.1, 0.2, 0.6>, <0.1, 0.16, 2.4>, <0.06, 0.6, 4.5>, <0.2, 2, 6>)
    rotate <-90, 50, 0>
    scale 0.8
    translate <-2.6, 0.8, -0.7>
}
object { Porcelain rotate <-90, -8, 0> scale 1.3 translate <0, 1.3, 1.7> }

// The floor: black stone, polished
plane {
    y, 0
    pigment { rgb 0.03 }
    normal { bumps 0.02 scale 0.4 }
    finish { ambient 0 diffuse 0.9 reflection { 0.06, 0.9 fresnel } }
    interior { ior 1.6 }
}
