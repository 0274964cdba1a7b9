// law reflected, seed 2
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -5> look_at <0, 0.7, 0> angle 45 }
plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } }
sphere { <1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
sphere { <-.2, 0.9, 0>, 0.8 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 } }
box { <-1.7, 0, 0.9>, <1.9, 1.9, 1.1> pigment { rgb 0.9 } finish { diffuse 1 } }
box { <-1.9, 0, -1.2>, <-1.7, 1.9, 1.1> pigment { rgb 0.9 } finish { diffuse 1 } }
sphere { <-0.5, 2.5, -0.9>, 0.3 pigment { rgb 1 } finish { diffuse 0 emission 5/*light 0*/ } }
