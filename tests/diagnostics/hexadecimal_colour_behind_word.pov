sphere { 0, 1 pigment { color #ff8800 } }
//! error: there is no directive `#ff8800`
//!  --> hexadecimal_colour_behind_word.pov:1:31
//!   |
//! 1 | sphere { 0, 1 pigment { color #ff8800 } }
//!   |                               ^^^^^^^
//! help: as a colour, write srgb <255, 136, 0>/255
