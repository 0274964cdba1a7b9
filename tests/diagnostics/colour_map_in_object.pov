// SPDX-License-Identifier: GPL-3.0-or-later
// A map that is not in its pigment
#version 3.7;
sphere { 0, 1 color_map { [0 rgb 1] } }
//! error: `color_map` has no place in `sphere`
//!  --> colour_map_in_object.pov:4:15
//!   |
//! 4 | sphere { 0, 1 color_map { [0 rgb 1] } }
//!   |               ^^^^^^^^^
//!   |
//!   = it belongs in `pigment`
//! help: sphere { centre, radius }
