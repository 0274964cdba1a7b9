// SPDX-License-Identifier: GPL-3.0-or-later
// A function gives a number
#version 3.7;
#declare F = function { <x,y,z> }
//! error: a function computes with single numbers only
//!  --> function_gives_vector.pov:4:25
//!   |
//! 4 | #declare F = function { <x,y,z> }
//!   |                         ^^^^^^^
