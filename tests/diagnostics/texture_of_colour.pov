// SPDX-License-Identifier: GPL-3.0-or-later
// A colour straight in a texture
#version 3.7;
sphere { 0, 1 texture { rgb <1,0,0> } }
//! error: a colour has no place in `texture`
//!  --> texture_of_colour.pov:4:25
//!   |
//! 4 | sphere { 0, 1 texture { rgb <1,0,0> } }
//!   |                         ^^^^^^^^^^^
//! help: an object gets its colour from a pigment: pigment { rgb <1, 0, 0> }
