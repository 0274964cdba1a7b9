// SPDX-License-Identifier: GPL-3.0-or-later
// A finish in a pigment
#version 3.7;
sphere { 0, 1 pigment { rgb 1 finish { ambient 1 } } }
//! error: `finish` has no place in `pigment`
//!  --> finish_in_pigment.pov:4:31
//!   |
//! 4 | sphere { 0, 1 pigment { rgb 1 finish { ambient 1 } } }
//!   |                               ^^^^^^
//!   |
//!   = it belongs in `texture`
//! help: pigment { rgb <r, g, b> }, or pigment { pattern [color_map { [0 rgb ...] [1 rgb ...] }] }
