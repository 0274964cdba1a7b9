// SPDX-License-Identifier: GPL-3.0-or-later
// A light with a texture
#version 3.7;
light_source { y, rgb 1 pigment { rgb 1 } }
//! error: `pigment` has no place in `light_source`
//!  --> light_without_colour_word.pov:4:25
//!   |
//! 4 | light_source { y, rgb 1 pigment { rgb 1 } }
//!   |                         ^^^^^^^
//!   |
//!   = it belongs in `texture`
//! help: light_source { location[, colour] [spotlight] [cylinder] [parallel] [point_at v] [radius n] [falloff n] ... }
