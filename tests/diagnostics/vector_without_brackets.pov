sphere { 0, 1 translate 1, 2, 3 }
sphere { 0, 1 scale 1, -2 1 pigment { rgb 1 } }
#declare A = 45;
sphere { 0, 1 rotate A, 0, 0 }
camera { location 0,0,-5 look_at 0,0,0 }
sphere { 0, 0, 0, 1 }
cylinder { 0, 0, 0, A, 1, 0, A }
plane { 0, 1, 0, 0 }
torus { 1, 0.5, 3 }
