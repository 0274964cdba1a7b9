// SPDX-License-Identifier: GPL-3.0-or-later
// A thing that glows a little beside a lamp: Declare=Shape=1 (isosurface) to 5 (difference), Declare=Glow=0 for none.
#version 3.7;
#ifndef (Shape) #declare Shape = 1; #end
#ifndef (Glow) #declare Glow = 0.05; #end
camera { location <0, 2.2, -5> look_at <0, 0.3, 0> angle 50 }
light_source { <6, 9, -7>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } finish { diffuse 0.8 } }
#declare Skin = texture { pigment { rgb <0.9, 0.5, 0.3> } finish { diffuse 0.7 emission Glow } }
#switch (Shape)
    #case (1)
        isosurface {
            function { x*x + y*y + z*z - 1 + 0.2*sin(7*x)*sin(7*y)*sin(7*z) }
            max_gradient 5 contained_by { box { -1.5, 1.5 } }
            texture { Skin }
        }
    #break
    #case (2)
        julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 60 texture { Skin } }
    #break
    #case (3)
        parametric {
            function { cos(u)*(1 + 0.35*cos(v)) } function { 0.35*sin(v) } function { sin(u)*(1 + 0.35*cos(v)) }
            <0, 0>, <2*pi, 2*pi> contained_by { box { -1.5, 1.5 } }
            accuracy 0.001 max_gradient 3 precompute 12 x, y, z
            texture { Skin }
        }
    #break
    #case (4)
        blob {
            threshold 0.6
            sphere { <-0.6, 0, 0>, 1, 1 } sphere { <0.6, 0, 0>, 1, 1 } sphere { <0, 0.8, 0>, 1, 1 }
            cylinder { <-1, -0.5, 0>, <1, -0.5, 0>, 0.5, 1 }
            texture { Skin }
        }
    #break
    #case (5)
        difference {
            box { -1, 1 } sphere { 0, 1.3 } cylinder { -2*y, 2*y, 0.5 }
            rotate 30*y
            texture { Skin }
        }
    #break
#end
