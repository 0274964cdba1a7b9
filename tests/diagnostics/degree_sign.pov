sphere { 0, 1 rotate 90°*y }
//! error: this is a degree sign, and angles are in degrees
//!  --> degree_sign.pov:1:24
//!   |
//! 1 | sphere { 0, 1 rotate 90°*y }
//!   |                        ^
//! help: leave it out
