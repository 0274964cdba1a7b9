// SPDX-License-Identifier: GPL-3.0-or-later
// A word of finish outside of it
#version 3.7;
sphere { 0, 1 ambient 1 }
//! error: `ambient` has no place in `sphere`
//!  --> finish_word_outside.pov:4:15
//!   |
//! 4 | sphere { 0, 1 ambient 1 }
//!   |               ^^^^^^^
//!   |
//!   = it belongs in `finish`
//! help: sphere { centre, radius }
