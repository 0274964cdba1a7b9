// SPDX-License-Identifier: GPL-3.0-or-later
// object { } of a texture
#version 3.7;
#declare T = texture { pigment { rgb 1 } }
object { T }
//! error: a texture has no place in `object`
//!  --> object_of_texture.pov:5:10
//!   |
//! 5 | object { T }
//!   |          ^
//! help: did you mean `texture { T }`?
