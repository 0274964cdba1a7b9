// SPDX-License-Identifier: GPL-3.0-or-later
// A letter that is not ASCII in a name
#version 3.7;
#declare Größe = 2;
//! error: a name consists of the letters A to Z and a to z, digits and `_`
//!  --> letter_of_another_language.pov:4:10
//!   |
//! 4 | #declare Größe = 2;
//!   |          ^^^^^
sphere { 0, Größe }
//! error: a name consists of the letters A to Z and a to z, digits and `_`
//!  --> letter_of_another_language.pov:5:13
//!   |
//! 5 | sphere { 0, Größe }
//!   |             ^^^^^
