// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the language as a name
#version 3.7;
#declare radius = 2;
//! error: `radius` is a word of the language and cannot be the name of something else
//!  --> name_reserved.pov:4:10
//!   |
//! 4 | #declare radius = 2;
//!   |          ^^^^^^
//! help: names with a capital letter are always free: `Radius`
#declare color = rgb 1;
//! error: `color` is a word of the language and cannot be the name of something else
//!  --> name_reserved.pov:5:10
//!   |
//! 5 | #declare color = rgb 1;
//!   |          ^^^^^
//! help: names with a capital letter are always free: `Color`
