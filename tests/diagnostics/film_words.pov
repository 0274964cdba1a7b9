#version 3.7;
camera {
    location -5*z
    film {
        exposure auto
        response agxx
//! error: there is no response of a film `agxx`
//!  --> film_words.pov:6:18
//!   |
//! 6 |         response agxx
//!   |                  ^^^^
//! help: did you mean `agx`? there are linear, filmic, agx
        pixel_filter gaussian
//! error: there is no pixel filter `gaussian`
//!  --> film_words.pov:7:22
//!   |
//! 7 |         pixel_filter gaussian
//!   |                      ^^^^^^^^
//! help: there are box, triangle, mitchell, blackman_harris
        white_balance 25000
//! error: `white_balance` of `film` must be from 0 to 15000, but it is 25000
//!  --> film_words.pov:8:23
//!   |
//! 8 |         white_balance 25000
//!   |                       ^^^^^ this is 25000
//! help: film { ... white_balance n ... }   white_balance: number from 0 to 15000, default 0
        glare { veil 2 rays 6 }
//! error: `veil` of `glare` must be from 0 to 1, but it is 2
//!  --> film_words.pov:9:22
//!   |
//! 9 |         glare { veil 2 rays 6 }
//!   |                      ^ this is 2
//! help: glare { ... veil n ... }   veil: number from 0 to 1, default 0.15
//! error: `glare` has no word `rays`
//!  --> film_words.pov:9:24
//!   |
//! 9 |         glare { veil 2 rays 6 }
//!   |                        ^^^^
//! help: glare { [veil n] [halo n] [star n] [blades n] [angle n] [length n] [field n] }
        vignete 0.3
//! error: `film` has no word `vignete`
//!   --> film_words.pov:10:9
//!    |
//! 10 |         vignete 0.3
//!    |         ^^^^^^^
//! help: did you mean `vignette`?
    }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
