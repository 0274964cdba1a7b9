// SPDX-License-Identifier: GPL-3.0-or-later
// A colour without pigment
#version 3.7;
sphere { 0, 1 rgb <1, 0, 0> }
//! error: a colour has no place in `sphere`
//!  --> colour_in_object.pov:4:15
//!   |
//! 4 | sphere { 0, 1 rgb <1, 0, 0> }
//!   |               ^^^^^^^^^^^^^
//! help: an object gets its colour from a pigment: pigment { rgb <1, 0, 0> }
