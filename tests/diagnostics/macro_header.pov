// SPDX-License-Identifier: GPL-3.0-or-later
// #macro of a word of the language, with directives inside
#version 3.7;
#macro sphere(R)
//! error: `sphere` is a word of the language and cannot be the name of something else
//!  --> macro_header.pov:4:8
//!   |
//! 4 | #macro sphere(R)
//!   |        ^^^^^^
//! help: names with a capital letter are always free: `Sphere`
  #if (1) #declare A = 1; #end
#end
