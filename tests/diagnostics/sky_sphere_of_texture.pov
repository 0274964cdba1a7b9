// SPDX-License-Identifier: GPL-3.0-or-later
// A sky has pigments only
#version 3.7;
sky_sphere { texture { pigment { rgb 1 } } }
//! error: `texture` has no place in `sky_sphere`
//!  --> sky_sphere_of_texture.pov:4:14
//!   |
//! 4 | sky_sphere { texture { pigment { rgb 1 } } }
//!   |              ^^^^^^^
//!   |
//!   = it belongs in `object`
//! help: sky_sphere { pigment { ... } [emission rgb 1] [transformations] }
