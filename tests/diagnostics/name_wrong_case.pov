// SPDX-License-Identifier: GPL-3.0-or-later
// Another case of letters
#version 3.7;
#declare Radius = 1;
sphere { 0, radius }
//! error: `radius` is a word of the language, and has no place here
//!  --> name_wrong_case.pov:5:13
//!   |
//! 5 | sphere { 0, radius }
//!   |             ^^^^^^
//! help: did you mean `Radius`, which is declared?
