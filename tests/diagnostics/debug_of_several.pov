// SPDX-License-Identifier: GPL-3.0-or-later
// #debug "a" "b"
#version 3.7;
#declare S = "abc";
#debug "S = " S "\n"
//! error: a string has no place in a scene
//!  --> debug_of_several.pov:5:15
//!   |
//! 5 | #debug "S = " S "\n"
//!   |               ^
//! help: strings are joined by concat(a, b)
