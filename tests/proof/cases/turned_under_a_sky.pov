// law writing, seed 1
#version 3.7;
#default { finish { ambient 0 diffuse 0.8 } }
global_settings { assumed_gamma 1 integrator { path_traced { bounces 1 } } }
camera { location <-1, 3, -5> look_at <0, 0.7, 0> angle 45 }
sky_sphere { pigment { rgb <0.3, 0.5, 0.8> } luminaire }
plane { y, 0 pigment { rgb 0.7 } }
union {
    box { -1, 1 rotate 20*x pigment { rgb <0.8, 0.6, 0.4> } }
    cylinder { <-1.5, 0.6, -1.3>, <-1.5, 1, 1.2>, 0.4 pigment { rgb <0.6, 0.3, 0.2> } }
    rotate 270*y
}
union {
    box { -0.5, 0.5 rotate 20*x pigment { rgb <0.8, 0.6, 0.4> } }
    rotate 180*y translate <-2,1,-1>
}
