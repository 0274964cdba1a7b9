// SPDX-License-Identifier: CC0-1.0
// A map of a world with its degrees: for pictures around spheres.
// The library's pictures/povmap.png is this scene with +W320 +H200 +A0.1.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -4*z direction z right 3.2*x up 2*y }
#declare Map_Finish = finish { emission 1 ambient 0 diffuse 0 }
box {
    <-1.6, -1, 0>, <1.6, 1, 1>
    pigment {
        bozo turbulence 0.5 octaves 6
        color_map {
            [0.5 rgb <0.1, 0.3, 0.7>] [0.5 rgb <0.2, 0.6, 0.2>]
            [0.62 rgb <0.2, 0.6, 0.2>] [0.62 rgb <0.6, 0.5, 0.3>]
        }
        scale 0.45 translate <0.2, 0.1, 0.7>
    }
    finish { Map_Finish }
}
// A line each 30 degrees.
#for (I, -6, 6)
    cylinder {
        <I*1.6/6, -1, -0.01>, <I*1.6/6, 1, -0.01>, 0.006
        pigment { rgb 0.9 } finish { Map_Finish }
    }
    #if (abs(I) < 6)
        text {
            internal 2 str(30*I, 0, 0), 0.1, 0 scale 0.11 translate <I*1.6/6 + 0.02, 0.03, -0.2>
            pigment { rgb 1 } finish { Map_Finish }
        }
    #end
#end
#for (I, -3, 3)
    cylinder {
        <-1.6, I/3, -0.01>, <1.6, I/3, -0.01>, 0.006
        pigment { rgb 0.9 } finish { Map_Finish }
    }
#end
