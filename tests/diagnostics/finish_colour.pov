// SPDX-License-Identifier: GPL-3.0-or-later
// A colour where a number is wanted
#version 3.7;
sphere { 0, 1 finish { diffuse rgb 1 } }
//! error: `diffuse` of `finish` must be a number, but it is a colour
//!  --> finish_colour.pov:4:32
//!   |
//! 4 | sphere { 0, 1 finish { diffuse rgb 1 } }
//!   |                                ^^^^^ this is a colour
//! help: finish { ... diffuse n[, n] ... }   diffuse: number, default 0.6
