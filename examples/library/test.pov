// SPDX-License-Identifier: CC0-1.0
// Four quarters that say where they are: for trying out mappings.
// The library's pictures/test.png is this scene with +W320 +H200 +A0.1.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location -z direction z right 1.6*x up y }
#declare Quarter_Finish = finish { emission 1 ambient 0 diffuse 0 }
#macro Quarter(X, Y, Colour, Letters)
    box {
        0, <0.8, 0.5, 1> translate <0.8*X - 0.8, 0.5*Y - 0.5, 0>
        pigment { Colour } finish { Quarter_Finish }
    }
    #for (I, 0, 2) #for (J, 0, 2)
        text {
            internal 2 Letters, 0.1, 0 scale 0.15
            translate <0.8*X - 0.76 + 0.26*I, 0.5*Y - 0.46 + 0.16*J, -0.2>
            pigment { rgb 0.05 } finish { Quarter_Finish }
        }
    #end #end
#end
Quarter(0, 1, rgb <1, 0.3, 1>, "TL")
Quarter(1, 1, rgb <1, 1, 0.3>, "TR")
Quarter(0, 0, rgb <0.3, 1, 1>, "BL")
Quarter(1, 0, rgb <1, 0.3, 0.3>, "BR")
text {
    internal 2 "Candelabra", 0.1, 0 scale 0.2 translate <-0.5, -0.06, -0.4>
    pigment { rgb 1 } finish { Quarter_Finish }
}
