// SPDX-License-Identifier: GPL-3.0-or-later
// Values of another kind than is wanted
#version 3.7;
#declare Red = rgb <1, 0, 0>;
#declare Wood = texture { pigment { rgb 0.5 } }
#declare Sizes = array[2] { 1, 2 }
sphere { Red, 1 }
//! error: `centre` of `sphere` must be a vector of 3, but it is a colour
//!  --> wrong_type.pov:7:10
//!   |
//! 7 | sphere { Red, 1 }
//!   |          ^^^ this is a colour
//! help: sphere { centre, radius }   centre: vector
sphere { 0, <1, 2, 3> }
//! error: `radius` of `sphere` must be a number, but it is a vector of 3
//!  --> wrong_type.pov:8:13
//!   |
//! 8 | sphere { 0, <1, 2, 3> }
//!   |             ^^^^^^^^^ this is a vector of 3
//! help: sphere { centre, radius }   radius: number, whose sign does not count
sphere { 0, "one" }
//! error: `radius` of `sphere` must be a number, but it is a string
//!  --> wrong_type.pov:9:13
//!   |
//! 9 | sphere { 0, "one" }
//!   |             ^^^^^ this is a string
//! help: sphere { centre, radius }   radius: number, whose sign does not count
sphere { 0, Sizes }
//! error: `radius` of `sphere` must be a number, but it is an array
//!   --> wrong_type.pov:10:13
//!    |
//! 10 | sphere { 0, Sizes }
//!    |             ^^^^^ this is an array
//! help: sphere { centre, radius }   radius: number, whose sign does not count
sphere { 0, 1 Wood }
//! error: a texture has no place in `sphere`
//!   --> wrong_type.pov:11:15
//!    |
//! 11 | sphere { 0, 1 Wood }
//!    |               ^^^^
//! help: did you mean `texture { Wood }`?
sphere { 0, 1 pigment { <1, 0, 0> } }
//! error: expected a colour, but this is a vector of 3
//!   --> wrong_type.pov:12:25
//!    |
//! 12 | sphere { 0, 1 pigment { <1, 0, 0> } }
//!    |                         ^^^^^^^^^
//! help: write `rgb <1, 0, 0>`
sphere { 0, 1 translate Wood }
//! error: `translate` of `sphere` must be a vector of 3, but it is a texture
//!   --> wrong_type.pov:13:25
//!    |
//! 13 | sphere { 0, 1 translate Wood }
//!    |                         ^^^^ this is a texture
//! help: sphere { ... translate v ... }   translate: vector, default 0
