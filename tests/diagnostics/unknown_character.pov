// SPDX-License-Identifier: GPL-3.0-or-later
// A character that the language has not
#version 3.7;
sphere { 0, 1 } $
//! error: this character means nothing here
//!  --> unknown_character.pov:4:17
//!   |
//! 4 | sphere { 0, 1 } $
//!   |                 ^
