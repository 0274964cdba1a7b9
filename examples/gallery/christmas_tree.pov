// SPDX-License-Identifier: CC0-1.0
// A fir in a snowy clearing, with 1500 LEDs whose colours run up it, and the snow that falls
// through their light. The picture is one of 150: `examples/gallery/render.sh film` makes all, six
// seconds that begin anew without a jump. Declare=Seed=... hangs the lights differently,
// Declare=Leds=... more.
#version 3.7;
#include "light_arrays.inc"
global_settings { assumed_gamma 1.0 max_trace_level 4 }

#ifndef (Leds) #declare Leds = 1500; #end
#ifndef (Seed) #declare Seed = 24; #end

camera {
    location <-0.6, 1.5, -8.4>
    right 16/9*x
    up y
    angle 59
    look_at <-0.5, 2.2, 0>
    film {
        exposure 1.2
        response agx
        vignette 0.3
        glare { veil 0.1 halo 0.004 star 0.02 blades 6 angle 12 length 0.35 }
    }
}
sky_sphere {
    pigment { gradient y color_map { [0 rgb <0.03, 0.06, 0.12>] [0.35 rgb <0.006, 0.012, 0.035>] } }
    pigment {
        bozo
        scale 0.004
        color_map { [0.9 rgbt 1] [0.96 rgb <0.25, 0.28, 0.35>] [1 rgb 0.9] }
    }
}
light_source { <40, 50, -20>, rgb <0.012, 0.02, 0.042> parallel point_at 0 }

#declare Matt = finish { ambient 0 diffuse 1 }
#declare Snow = texture {
    pigment { rgb <0.82, 0.85, 0.9> }
    normal { granite 0.12 scale 0.5 }
    finish { Matt }
}
#declare Random = seed(Seed);

// A fir: twigs wind round the trunk by the golden angle, shorter and shorter; each keeps some snow
#macro Fir(Twigs)
    cylinder { 0, 4.3*y, 0.09 pigment { rgb <0.2, 0.12, 0.07> } finish { Matt } }
    #for (I, 0, Twigs - 1)
        #local Part = pow(I/Twigs, 0.8);
        #local Foot = <0, 0.5 + 3.9*Part, 0>;
        #local Reach = (1.6*(1 - Part) + 0.06)*(0.72 + 0.28*rand(Random));
        #local Tip = Foot + vrotate(<Reach, -0.32*Reach, 0>, 137.508*I*y);
        #declare Tips[I] = Tip;
        cone { Foot, 0.05, Tip, 0.012 }
        #for (Side, -1, 1, 2)
            #local Middle = 0.45*Foot + 0.55*Tip;
            cone {
                Middle, 0.03, Middle + vrotate(<0.32*Reach, -0.08, 0.2*Reach*Side>, 137.508*I*y),
                0.008
            }
        #end
        #if (mod(I, 3) = 0)
            sphere {
                0, 1
                scale <0.2*Reach + 0.03, 0.03, 0.07>
                rotate 17*z
                rotate 137.508*I*y
                translate 0.3*Foot + 0.7*Tip + 0.03*y
                texture { Snow }
            }
        #end
    #end
#end
#declare Twigs = 2600;
#declare Tips = array[Twigs];
#declare Needles = texture { pigment { rgb <0.07, 0.22, 0.1> } finish { Matt } }
#declare Tree = union { Fir(Twigs) texture { Needles } }
object { Tree }
#declare Own_Tips = Tips;

// The forest behind it, where no lamp hangs
#for (I, 0, 26)
    object {
        Tree
        rotate 360*rand(Random)*y
        scale <1, 1.1 + 0.7*rand(Random), 1>*(1 + 0.4*rand(Random))
        translate <-19 + 1.4*I + rand(Random), 0, 5.5 + 7*rand(Random) + 0.02*pow(abs(I - 13), 2)>
    }
#end

// LEDs at the tips: bands of colour wind round the tree and climb by one turn in a film
#declare Palette = array[5] {
    <1, 0.05, 0.02>, <1, 0.4, 0.06>, <0.08, 0.9, 0.15>, <0.04, 0.25, 1>, <0.9, 0.06, 0.6>
}
#declare Places = array[Leds];
#declare Colours = array[Leds];
#for (I, 0, Leds - 1)
    #declare Place = Own_Tips[int((I + rand(Random))*Twigs/Leds)];
    #declare Places[I] = Place*1.02;
    #declare Turn = atan2(Place.z, Place.x)/(2*pi) + 0.42*Place.y + 1 - clock;
    #declare Band = 5*(Turn - floor(Turn));
    #declare Twinkle = 0.55 + 0.45*sin(2*pi*(rand(Random) + int(1 + 3*rand(Random))*clock));
    #declare Colours[I] = rgb Twinkle*Palette[int(Band)];
#end
object { Light_Positions_Coloured(sphere { 0, 0.021 }, Places, Colours, 42) }

// A star on the top
union {
    #for (I, 0, 4)
        cone { 0, 0.075, 0.28*y, 0 rotate 72*I*z }
    #end
    pigment { rgb <1, 0.6, 0.2> }
    finish { ambient 0 diffuse 0 emission 9 }
    translate 4.6*y
}

// Snow on the ground, in drifts, and a hut far behind with light in its windows
plane { y, 0 texture { Snow } }
#for (I, 0, 6)
    sphere {
        0, 1
        scale <3 + 2*rand(Random), 0.5 + 0.35*rand(Random), 1.6>
        translate <-13 + 4*I, -0.1, 3.2 + 1.5*rand(Random)>
        texture { Snow }
    }
#end
union {
    box { <-1, 0, 0>, <1, 1.1, 1.5> pigment { rgb <0.2, 0.1, 0.05> } finish { Matt } }
    prism {
        linear_sweep linear_spline 0, 1.8, 4 <-1.25, 0>, <1.25, 0>, <0, 1>, <-1.25, 0>
        rotate -90*x
        translate <0, 1.05, 1.6>
        texture { Snow }
    }
    #for (Side, -1, 1, 2)
        box {
            <-0.22, 0.4, -0.02>, <0.22, 0.85, 0>
            translate 0.5*Side*x
            pigment { rgb <1, 0.45, 0.12> }
            finish { ambient 0 diffuse 0 emission 1.6 }
        }
    #end
    rotate -16*y
    translate <-4.4, 0.15, 2.4>
}

// Presents where the tree lights them
#for (I, 0, 7)
    union {
        box { <-0.22, 0, -0.22>, <0.22, 0.3, 0.22> pigment { rgb 0.15 + 0.5*Palette[mod(I, 5)] } }
        box { <-0.04, 0, -0.225>, <0.04, 0.305, 0.225> pigment { rgb <0.8, 0.7, 0.4> } }
        finish { Matt }
        scale 0.6 + 0.5*rand(Random)
        rotate 360*rand(Random)*y
        translate vrotate((1.75 + 0.7*mod(I, 2) + 0.2*rand(Random))*x, (28 + 18*I)*y)
    }
#end

// Flakes fall by a whole number of rooms in a film, and sway
#for (I, 1, 1600)
    #declare Height = rand(Random) - (1 + int(2*rand(Random)))*clock;
    sphere {
        <9*(rand(Random) - 0.5), 6*(Height - floor(Height)), 8*rand(Random) - 5>
        + 0.1*sin(2*pi*(clock + rand(Random)))*x,
        0.009 + 0.008*rand(Random)
        pigment { rgb 0.9 } finish { Matt emission 0.05 no_luminaire } no_shadow
    }
#end
