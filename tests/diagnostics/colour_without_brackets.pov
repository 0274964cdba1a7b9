sphere { 0, 1 pigment { color rgb 1, 0, 0 } }
//! error: the numbers of a colour stand in `< >`
//!  --> colour_without_brackets.pov:1:38
//!   |
//! 1 | sphere { 0, 1 pigment { color rgb 1, 0, 0 } }
//!   |                                      ^
//! help: write `color rgb <1, 0, 0>`
sphere { 0, 1 pigment { color 1, 0.5, 0 } }
//! error: the numbers of a colour stand in `< >`
//!  --> colour_without_brackets.pov:2:34
//!   |
//! 2 | sphere { 0, 1 pigment { color 1, 0.5, 0 } }
//!   |                                  ^^^
//! help: write `color <1, 0.5, 0>`
sphere { 0, 1 pigment { rgbt 1, 0, 0, 0.5 } }
//! error: the numbers of a colour stand in `< >`
//!  --> colour_without_brackets.pov:3:33
//!   |
//! 3 | sphere { 0, 1 pigment { rgbt 1, 0, 0, 0.5 } }
//!   |                                 ^
//! help: write `rgbt <1, 0, 0, 0.5>`
light_source { <0, 10, 0> rgb 1, 1, 1 }
//! error: the numbers of a colour stand in `< >`
//!  --> colour_without_brackets.pov:4:34
//!   |
//! 4 | light_source { <0, 10, 0> rgb 1, 1, 1 }
//!   |                                  ^
//! help: write `rgb <1, 1, 1>`
background { rgb 0.1, 0.2, 0.3 }
//! error: the numbers of a colour stand in `< >`
//!  --> colour_without_brackets.pov:5:23
//!   |
//! 5 | background { rgb 0.1, 0.2, 0.3 }
//!   |                       ^^^
//! help: write `rgb <0.1, 0.2, 0.3>`
