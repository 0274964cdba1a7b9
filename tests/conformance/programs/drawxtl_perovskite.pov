/*

POVxtl-Persistence of Vision Ray Tracer
Crystal Structure Drawing Program V5.5

Copyright 1996, 1997, 2000-2011 by Larry Finger, Martin Kroeker, and Brian Toby
   (all rights reserved).

Scene file created from cell.str 
with command line options: -b   6.40   6.40   6.40 -o  0.50  0.50  0.50 
-p -0.10  0.60 -0.10  0.60 -0.10  0.60 -v 10.00 20.00  5.00 -m  1.00
*/

#if (version>3.65)
#version 3.6;
#end

#include "colors.inc"
#include "chars.inc"

default {
        finish {
                ambient  0.70
                diffuse  0.30
                specular  0.08
                roughness  0.01
               }
        }

camera{
 location< -0.882784 ,-0.698974, 151.619217>
 up <0, 0.1, 0>
 right <-0.1, 0, 0>
 look_at <-0.882784,-0.698974,0>
}
background{color White}
light_source {< 0, 0, 94.762009>
color red 4.0 green 4.0 blue 4.0
}
object{
 union{

#declare xrot =  10.0;
#declare yrot =  20.0;
#declare zrot =   5.0;
#declare xmove =   0.0;
#declare ymove =   0.0;

  cylinder{<-2.000000,-2.000000,-2.000000>,<-2.000000,-2.000000,2.000000>,0.018952 
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<-2.000000,-2.000000,2.000000>,<-2.000000,2.000000,2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<-2.000000,2.000000,2.000000>,<-2.000000,2.000000,-2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<-2.000000,2.000000,-2.000000>,<-2.000000,-2.000000,-2.000000>, 0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<-2.000000,-2.000000,-2.000000>,<2.000000,-2.000000,-2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,-2.000000,-2.000000>,<2.000000,2.000000,-2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,2.000000,-2.000000>,<2.000000,2.000000,2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,2.000000,2.000000>,<2.000000,-2.000000,2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,-2.000000,2.000000>,<2.000000,-2.000000,-2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,2.000000,-2.000000>,<-2.000000,2.000000,-2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<-2.000000,2.000000,2.000000>,<2.000000,2.000000,2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
  cylinder{<2.000000,-2.000000,2.000000>,<-2.000000,-2.000000,2.000000>,0.018952
   texture{pigment{color Black }}
   no_shadow no_reflection
  }
 /* Sphere for Sr   at  0.50000  0.50000  0.50000 */ 
 sphere{< 0.00000,  0.00000,  0.00000>,  0.40000
  texture{pigment{color Green  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at  0.50000  0.00000  0.00000 */ 
 sphere{< 0.00000, -2.00000, -2.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at  0.00000  0.00000  0.50000 */ 
 sphere{<-2.00000, -2.00000,  0.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at  0.00000  0.50000  0.00000 */ 
 sphere{<-2.00000,  0.00000, -2.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at -0.50000  0.00000  0.00000 */ 
 sphere{<-4.00000, -2.00000, -2.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at  0.00000 -0.50000  0.00000 */ 
 sphere{<-2.00000, -4.00000, -2.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Sphere for O    at  0.00000  0.00000 -0.50000 */ 
 sphere{<-2.00000, -2.00000, -4.00000>,  0.20000
  texture{pigment{color Red  }}
   finish{phong  0.20 phong_size  1.00}
 }
 /* Polyhedron (6) around Ti    1 at  0.00000  0.00000  0.00000 */ 
/* 3-sided polygon */
 triangle {<  0.00000, -2.00000, -2.00000>,
<-2.00000,  0.00000, -2.00000>, <-2.00000, -2.00000,  0.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {<  0.00000, -2.00000, -2.00000>,
<-2.00000, -2.00000,  0.00000>, <-2.00000, -4.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {<  0.00000, -2.00000, -2.00000>,
<-2.00000,  0.00000, -2.00000>, <-2.00000, -2.00000, -4.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {<  0.00000, -2.00000, -2.00000>,
<-2.00000, -2.00000, -4.00000>, <-2.00000, -4.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {< -2.00000, -2.00000,  0.00000>,
<-2.00000,  0.00000, -2.00000>, <-4.00000, -2.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {< -2.00000, -2.00000,  0.00000>,
<-2.00000, -4.00000, -2.00000>, <-4.00000, -2.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {< -2.00000,  0.00000, -2.00000>,
<-2.00000, -2.00000, -4.00000>, <-4.00000, -2.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* 3-sided polygon */
 triangle {< -4.00000, -2.00000, -2.00000>,
<-2.00000, -2.00000, -4.00000>, <-2.00000, -4.00000, -2.00000>
  texture{pigment{color Blue  }}
 }
/* Labels */
  text { ttf "crystal.ttf","o" 0.15,0
    scale <0.42,0.42,0.42>
    rotate <0, 0, -zrot>
    rotate <0, -yrot, 0>
    rotate <-xrot,0, 0>
    translate <-2.50000,-2.50000,-2.50000> pigment{color Black}
  }
/* Labels */
  text { ttf "crystal.ttf","a" 0.15,0
    scale <0.42,0.42,0.42>
    rotate <0, 0, -zrot>
    rotate <0, -yrot, 0>
    rotate <-xrot,0, 0>
    translate < 2.50000,-2.00000,-2.00000> pigment{color Black}
  }
/* Labels */
  text { ttf "crystal.ttf","b" 0.15,0
    scale <0.42,0.42,0.42>
    rotate <0, 0, -zrot>
    rotate <0, -yrot, 0>
    rotate <-xrot,0, 0>
    translate <-2.00000, 2.50000,-2.00000> pigment{color Black}
  }
/* Labels */
  text { ttf "crystal.ttf","c" 0.15,0
    scale <0.42,0.42,0.42>
    rotate <0, 0, -zrot>
    rotate <0, -yrot, 0>
    rotate <-xrot,0, 0>
    translate <-2.00000,-2.00000, 2.50000> pigment{color Black}
  }
 }
rotate <xrot, 0, 0>
rotate <0, yrot, 0>
rotate <0, 0, zrot>
translate <xmove, ymove, 0>
}
