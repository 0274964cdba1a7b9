#version 3.7;
camera {
    location -5*z
    film {
        exposure auto
        response agxx
        pixel_filter gaussian
        white_balance 25000
        glare { veil 2 rays 6 }
        vignete 0.3
    }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
