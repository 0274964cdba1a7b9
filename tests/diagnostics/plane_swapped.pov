// SPDX-License-Identifier: GPL-3.0-or-later
// Normal and distance exchanged
#version 3.7;
plane { 0, y }
//! error: `distance` of `plane` must be a number, but it is a vector of 3
//!  --> plane_swapped.pov:4:12
//!   |
//! 4 | plane { 0, y }
//!   |            ^ this is a vector of 3
//! help: plane { normal, distance }   distance: number
