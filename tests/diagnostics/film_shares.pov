#version 3.7;
camera {
    location -5*z
    film { white_balance 500 }
//! error: a white balance is between 1000 and 15000 kelvins, or 0 for none
//!  --> film_shares.pov:4:5
//!   |
//! 4 |     film { white_balance 500 }
//!   |     ^^^^
//! help: film { [exposure n] [auto_exposure] [key n] [white_balance n] [response v] [contrast n] [saturation n] ... }
}
camera {
    location -5*z
    film { glare { veil 0.9 star 0.2 } }
//! error: the shares of `glare` are more than all light together
//!  --> film_shares.pov:8:5
//!   |
//! 8 |     film { glare { veil 0.9 star 0.2 } }
//!   |     ^^^^
//! help: film { [exposure n] [auto_exposure] [key n] [white_balance n] [response v] [contrast n] [saturation n] ... }
}
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
