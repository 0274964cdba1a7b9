#version 3.7;
film { exposure 1 }
camera {
    location -5*z
    glare { veil 0.2 }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
