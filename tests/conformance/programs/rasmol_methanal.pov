// File: rasmol_methanal.pov
// Creator: RasMol Version 2.7.6.0
// Version: POV-Ray Version 3
// Needs objectfile "rasmol_methanal.inc"

// Original image size: H = 576, W = 576

// OrigCX = 348, OrigCY = -17, OrigCZ = 16, Scale = 0.268156

// Camera
camera {
    orthographic
    location <0.373274, -0.0182346, -40>
    look_at <0.373274, -0.0182346, -0.017162>
    up <0, -2.304, 0>
    right <2.304, 0, 0>
}

// Light
light_source {<20000, -20000, -40000> color rgb <1.0, 1.0, 1.0>}

background { color rgb <0, 0, 0> }

union {   
// Objects
   // union finish
   // change "T" to a higher value (up to 1.0, e.g. 0.8) and
   // uncomment "hollow" to make your object transparent
   #declare F = finish { specular 0.4 roughness 0.005
                         diffuse 0.8
                         ambient 0.2 }
   #declare T = 0
   #include "rasmol_methanal.inc"
   // no_shadow
   // hollow
   matrix 
        < 0.268156,	0,	-0,
          0,	0.268156,	-0,
          -0,	-0,	0.268156,
          0,	0,	0 >
}
