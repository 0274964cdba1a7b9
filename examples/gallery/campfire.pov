// SPDX-License-Identifier: CC0-1.0
// A campfire: the flames are a medium that is a luminaire, so they light the logs, the stones and
// the trees around them, and the smoke above.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }

camera {
    location <0.2, 1.25, -5.2>
    right 4/3*x
    up y
    angle 46
    look_at <0, 0.85, 0>
    film { exposure 3.2 response agx vignette 0.25 glare { veil 0.1 halo 0.01 } }
}

#declare Matt = finish { ambient 0 diffuse 0.85 }
#declare Dice = seed(11);

// The flames: three tongues, which the wind frays
#declare Tongue = function { max(0, 1 - sqrt(x*x + z*z) / (0.03 + 0.62*sqrt(max(y, 0))*max(1 - pow(max(y, 0), 0.8), 0))) }
#macro Flame(High, Wide, Lean, Phase)
    density {
        function { Tongue(x, y, z) }
        color_map {
            [0.00 rgb 0]
            [0.12 rgb <0.30, 0.05, 0.00>]
            [0.40 rgb <1.00, 0.34, 0.06>]
            [0.75 rgb <1.60, 0.85, 0.30>]
            [1.00 rgb <1.20, 0.90, 0.50>]
        }
        translate Phase*y
        warp { turbulence <0.22, 0.12, 0.22> octaves 4 omega 0.55 }
        translate -Phase*y
        scale <Wide, High, Wide>
        rotate Lean
    }
#end
#macro Fire(High, Wide, Lean, Phase, Place)
    box {
        <-0.75*Wide, 0, -0.75*Wide>, <0.75*Wide, 1.25*High, 0.75*Wide>
        translate Place
        pigment { rgbt 1 }
        finish { ambient 0 diffuse 0 }
        hollow
        interior {
            media { emission 14 absorption 0.6 Flame(High, Wide, Lean, Phase) translate Place }
            luminaire
        }
    }
#end
Fire(1.45, 0.85, <0, 0, 3>, 3.1, <0.02, 0.10, 0>)
Fire(0.95, 0.60, <0, 0, 14>, 7.7, <-0.26, 0.10, -0.12>)
Fire(1.05, 0.60, <0, 0, -12>, 12.4, <0.27, 0.10, 0.06>)

// Logs that lean together, and embers between them
#declare Bark = texture {
    pigment {
        wood
        turbulence 0.2
        color_map { [0 rgb <0.10, 0.055, 0.03>] [1 rgb <0.035, 0.02, 0.012>] }
        scale 0.06
    }
    normal { wrinkles 0.9 scale <0.03, 0.2, 0.03> }
    finish { Matt }
}
#for (I, 0, 6)
    cylinder {
        <0.62, 0.03, 0>, <-0.02, 0.62, 0>, 0.055 + 0.02*rand(Dice)
        texture { Bark rotate 90*z }
        rotate (I*360/7 + 16*rand(Dice))*y
    }
#end
#for (I, 0, 60)
    sphere {
        <0.33*sqrt(rand(Dice)), 0.03, 0>, 0.025 + 0.03*rand(Dice)
        rotate 360*rand(Dice)*y
        pigment { rgb <0.9, 0.16, 0.03> }
        finish { ambient 0 diffuse 0.2 emission 2.5*rand(Dice) }
    }
#end

// A ring of stones, a log to sit on, and the ground
#for (I, 0, 13)
    sphere {
        0, 0.13 + 0.04*rand(Dice)
        scale <1.25, 0.8, 1>
        rotate 360*rand(Dice)*y
        translate <0.92 + 0.05*rand(Dice), 0.07, 0>
        rotate (I*360/14 + 5*rand(Dice))*y
        pigment { granite color_map { [0 rgb 0.28] [1 rgb 0.55] } scale 0.2 }
        normal { granite 0.3 scale 0.25 }
        finish { Matt }
    }
#end
cylinder { <-2.6, 0.22, 1.5>, <-1.0, 0.22, 2.0>, 0.22 texture { Bark scale 2 rotate <0, -17, 90> } }
plane {
    y, 0
    pigment { bozo color_map { [0 rgb <0.13, 0.11, 0.06>] [1 rgb <0.10, 0.13, 0.05>] } scale 0.7 }
    normal { bumps 0.5 scale 0.05 }
    finish { Matt }
}

// Trees at the edge of the light
#for (I, 0, 16)
    #declare Away = 3.2 + 3.4*rand(Dice);
    #declare Turn = -75 + 150*(I + rand(Dice))/17;
    union {
        cylinder { 0, 6*y, 0.16 + 0.1*rand(Dice) texture { Bark scale 2.5 } }
        #for (J, 0, 4)
            cone {
                <0, 1.6 + 0.7*J, 0>, 0.95 - 0.12*J, <0, 2.9 + 0.7*J, 0>, 0.05
                pigment { rgb <0.07, 0.14, 0.06> }
                normal { bumps 0.9 scale 0.06 }
                finish { Matt }
            }
        #end
        translate <0, 0, Away>
        rotate Turn*y
    }
#end
light_source { <6, 9, -4>, rgb <0.003, 0.005, 0.010> parallel point_at 0 }
