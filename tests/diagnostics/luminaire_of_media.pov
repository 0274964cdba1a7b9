#version 3.7;
#default { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
light_source { <9, 9, -9>, rgb 1 }
// Nothing that is emitted
sphere { 0, 1 hollow interior { media { absorption 1 } luminaire } }
//! warning[no-effect]: `luminaire` has no effect: no media of the interior emit light
//!  --> luminaire_of_media.pov:5:22
//!   |
//! 5 | sphere { 0, 1 hollow interior { media { absorption 1 } luminaire } }
//!   |                      ^^^^^^^^
//! help: interior { media { emission 2 } luminaire }
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
