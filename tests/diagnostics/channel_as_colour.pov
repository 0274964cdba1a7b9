// SPDX-License-Identifier: GPL-3.0-or-later
// colour red
#version 3.7;
sphere { 0, 1 pigment { colour red } }
//! error: expected a value, but found `}`
//!  --> channel_as_colour.pov:4:36
//!   |
//! 4 | sphere { 0, 1 pigment { colour red } }
//!   |                                    ^
//! help: red, green and blue are channels, and need a number; colors.inc declares the colours Red, Green and Blue
