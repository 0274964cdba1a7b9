// SPDX-License-Identifier: GPL-3.0-or-later
// A texture in the scene
#version 3.7;
#declare T = texture { pigment { rgb 1 } }
T
//! error: a texture has no place in a scene
//!  --> texture_as_object.pov:5:1
//!   |
//! 5 | T
//!   | ^
//! help: did you mean `texture { T }`?
