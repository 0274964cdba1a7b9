// SPDX-License-Identifier: GPL-3.0-or-later
// a colour of a web page
#version 3.7;
sphere { 0, 1 pigment { #ff8000 } }
//! error: there is no directive `#ff8000`
//!  --> hexadecimal_colour.pov:4:25
//!   |
//! 4 | sphere { 0, 1 pigment { #ff8000 } }
//!   |                         ^^^^^^^
//! help: as a colour, write srgb <255, 128, 0>/255
