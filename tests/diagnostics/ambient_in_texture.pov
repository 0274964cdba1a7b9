// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the finish in the texture
#version 3.7;
sphere { 0, 1 texture { pigment { rgb 1 } ambient 0.5 } }
//! error: `ambient` has no place in `texture`
//!  --> ambient_in_texture.pov:4:43
//!   |
//! 4 | sphere { 0, 1 texture { pigment { rgb 1 } ambient 0.5 } }
//!   |                                           ^^^^^^^
//!   |
//!   = it belongs in `finish`
//! help: texture { [Name] pigment { ... } normal { ... } finish { ... } [transformations] }
