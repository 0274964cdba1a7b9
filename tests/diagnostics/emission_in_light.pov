// SPDX-License-Identifier: GPL-3.0-or-later
// emission belongs to an object
#version 3.7;
light_source { y, rgb 1 emission 3 }
//! error: `emission` has no place in `light_source`
//!  --> emission_in_light.pov:4:25
//!   |
//! 4 | light_source { y, rgb 1 emission 3 }
//!   |                         ^^^^^^^^
//!   |
//!   = it belongs in `finish`, `sky_sphere`, `media`
//! help: light_source { location[, colour] [spotlight] [cylinder] [parallel] [point_at v] [radius n] [falloff n] ... }
