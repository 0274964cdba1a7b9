#version 3.7;
#default { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
light_source { <9, 9, -9>, rgb 1 }
// Nothing that is emitted
sphere { 0, 1 hollow interior { media { absorption 1 } luminaire } }
// Not hollow
sphere { 3*x, 1 interior { media { emission 1 } luminaire } }
// Without an end
plane { y, -5 hollow interior { media { emission 1 } luminaire } }
// A surface that is not closed for points
mesh {
    triangle { <6, 0, 0>, <8, 0, 0>, <7, 2, 0> }
    inside_vector y
    hollow
    interior { media { emission 1 } luminaire }
}
camera { location -20*z }
