// SPDX-License-Identifier: GPL-3.0-or-later
// A channel without its value
#version 3.7;
sphere { 0, 1 pigment { color red 1 green } }
//! error: expected a value, but found `}`
//!  --> channel_without_value.pov:4:43
//!   |
//! 4 | sphere { 0, 1 pigment { color red 1 green } }
//!   |                                           ^
//! help: red, green and blue are channels, and need a number; colors.inc declares the colours Red, Green and Blue
