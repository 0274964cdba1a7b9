// SPDX-License-Identifier: GPL-3.0-or-later
// Colours go from 0 to 1: legal, but bright
#version 3.7;
light_source { 0, rgb <255, 128, 0> }
sphere { 0, 1 pigment { rgb (1, 0, 0) } }
//! error: values in parentheses are no vector
//!  --> colour_of_255.pov:5:29
//!   |
//! 5 | sphere { 0, 1 pigment { rgb (1, 0, 0) } }
//!   |                             ^^^^^^^^^
//! help: a vector is written between `<` and `>`: <1, 2, 3>
