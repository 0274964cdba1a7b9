// SPDX-License-Identifier: GPL-3.0-or-later
// A letter that is wrong
#version 3.7;
#declare Radius = 1;
sphere { 0, Raduis }
//! error: nothing is declared as `Raduis`
//!  --> name_misspelt.pov:5:13
//!   |
//! 5 | sphere { 0, Raduis }
//!   |             ^^^^^^
//! help: did you mean `Radius`?
