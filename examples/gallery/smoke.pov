// SPDX-License-Identifier: CC0-1.0
// A lantern in the smoke that rises from incense: its flame and three more light the wisps.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }

camera {
    location <0.3, 1.1, -4.6>
    right 4/3*x
    up y
    angle 44
    look_at <0.1, 0.98, 0>
    film {
        exposure 1.9
        response agx
        vignette 0.3
        glare { veil 0.12 halo 0.004 star 0.015 blades 6 angle 10 length 0.3 }
    }
}

#declare Matt = finish { ambient 0 diffuse 0.9 }
#declare Iron = texture { pigment { rgb 0.03 } finish { Matt specular 0.5 roughness 0.03 } }
#macro Flame(Radiance)
    sphere {
        0, 0.035
        scale <1, 2.2, 1>
        pigment { rgb <1, 0.48, 0.14> }
        finish { ambient 0 diffuse 0 emission Radiance }
    }
#end

// The lantern: four posts and a roof around a candle; the glass is left out
union {
    box { <-0.3, 0, -0.3>, <0.3, 0.06, 0.3> }
    #for (I, 0, 3)
        box { <-0.3, 0.06, -0.3>, <-0.26, 0.8, -0.26> rotate 90*I*y }
        box { <-0.28, 0.42, -0.29>, <0.28, 0.44, -0.275> rotate 90*I*y }
        box { <-0.01, 0.06, -0.29>, <0.01, 0.8, -0.275> rotate 90*I*y }
        triangle { <-0.36, 0.8, -0.36>, <0.36, 0.8, -0.36>, <0, 1.08, 0> rotate 90*I*y }
    #end
    torus { 0.12, 0.015 rotate 90*x translate 1.18*y }
    texture { Iron }
    rotate 25*y
    translate <-0.25, 0, 0.35>
}
cylinder {
    <-0.25, 0.06, 0.35>, <-0.25, 0.3, 0.35>, 0.08
    pigment { rgb <0.8, 0.7, 0.5> }
    finish { Matt }
}
object { Flame(170) translate <-0.25, 0.4, 0.35> }

// Three small candles, and the bowl of incense
#for (I, 0, 2)
    union {
        cylinder { 0, 0.07*y, 0.07 pigment { rgb <0.75, 0.35, 0.15> } finish { Matt } }
        object { Flame(70) scale 0.8 translate 0.13*y }
        translate <0.72 + 0.28*I, 0, 0.35 - 0.55*mod(I, 2)>
    }
#end
difference {
    sphere { 0, 0.2 }
    sphere { 0, 0.18 }
    plane { -y, 0 }
    translate <0.25, 0.2, -0.3>
    texture { Iron }
}

// The table and the dark behind it
plane {
    y, 0
    pigment {
        wood
        turbulence 0.05
        color_map { [0 rgb <0.16, 0.08, 0.04>] [1 rgb <0.09, 0.04, 0.02>] }
        scale 0.12
        rotate <3, 80, 0>
    }
    finish { Matt specular 0.2 roughness 0.05 reflection 0.04 }
}
plane { -z, -1.6 pigment { rgb <0.3, 0.22, 0.17> } normal { granite 0.2 scale 0.8 } finish { Matt } }
light_source { <-8, 9, -6>, rgb <0.004, 0.007, 0.014> parallel point_at 0 }

// The smoke: a column that leans and comes apart as it rises
box {
    <-1.6, 0.02, -0.9>, <1.7, 2.3, 0.9>
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 }
    hollow
    interior {
        media {
            scattering { 5, rgb <1, 1.02, 1.06>*3 eccentricity 0.3 extinction 1 }
            density {
                cylindrical
                color_map { [0 rgb 0] [0.35 rgb 0.12] [1 rgb 1] }
                scale <0.34, 1, 0.34>
                warp { turbulence <0.5, 0.15, 0.5> octaves 6 omega 0.6 }
                scale <1, 1.6, 1>
                rotate 7*z
                translate <0.25, 0.2, -0.3>
            }
            density {
                bozo
                color_map { [0.3 rgb 0.04] [0.55 rgb 1] }
                scale <0.14, 0.34, 0.14>
                warp { turbulence 0.45 octaves 5 }
            }
        }
    }
}
