#version 3.7;
film { exposure 1 }
//! error: a scene has no word `film`
//!  --> film_outside.pov:2:1
//!   |
//! 2 | film { exposure 1 }
//!   | ^^^^
//!   |
//!   = it belongs in `camera`
camera {
    location -5*z
    glare { veil 0.2 }
//! error: `camera` has no word `glare`
//!  --> film_outside.pov:5:5
//!   |
//! 5 |     glare { veil 0.2 }
//!   |     ^^^^^
//!   |
//!   = it belongs in `film`
//! help: camera { perspective [location v] [direction v] [right v] [up v] [sky v] [look_at v] [aperture n] ... }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
