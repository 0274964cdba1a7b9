// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the language as a parameter
#version 3.7;
#macro Lamp(radius)
//! error: `radius` is a word of the language and cannot be the name of something else
//!  --> macro_parameter_reserved.pov:4:13
//!   |
//! 4 | #macro Lamp(radius)
//!   |             ^^^^^^
//! help: names with a capital letter are always free: `Radius`
    sphere { 0, radius }
#end
