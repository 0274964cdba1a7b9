#version 3.7;
camera {
    location -5*z
    film { white_balance 500 }
}
camera {
    location -5*z
    film { glare { veil 0.9 star 0.2 } }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
