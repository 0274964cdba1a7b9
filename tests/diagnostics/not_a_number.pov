// SPDX-License-Identifier: GPL-3.0-or-later
// Infinity as a radius
#version 3.7;
sphere { 0, 1 / 0 }
//! warning[division-by-zero]: division by zero; the result is infinite
//!  --> not_a_number.pov:4:17
//!   |
//! 4 | sphere { 0, 1 / 0 }
//!   |                 ^ this is 0
//! error: `radius` of `sphere` must be finite, but it is inf
//!  --> not_a_number.pov:4:13
//!   |
//! 4 | sphere { 0, 1 / 0 }
//!   |             ^^^^^ this is inf
//! help: sphere { centre, radius }   radius: number, whose sign does not count
