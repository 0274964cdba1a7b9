// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of a map without their brackets
#version 3.7;
sphere { 0, 1 pigment { gradient y color_map { 0 rgb 1, 1 rgb 0 } } }
//! error: a number has no place in `color_map`
//!  --> colour_map_without_brackets.pov:4:48
//!   |
//! 4 | sphere { 0, 1 pigment { gradient y color_map { 0 rgb 1, 1 rgb 0 } } }
//!   |                                                ^
//! help: color_map { [0 rgb <r, g, b>] [1 rgb <r, g, b>] }
