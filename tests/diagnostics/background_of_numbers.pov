#version 3.7;
background { 1, 0, 0 }
//! error: `background` takes 1 value, and a vector among them stands in `< >`
//!  --> background_of_numbers.pov:2:17
//!   |
//! 2 | background { 1, 0, 0 }
//!   |                 ^
//! help: write `background { rgb <1, 0, 0> }`
