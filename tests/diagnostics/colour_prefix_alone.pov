// SPDX-License-Identifier: GPL-3.0-or-later
// A colour of which only the first word is there
#version 3.7;
camera { location -5*z }
sphere { 0, 1 pigment { rgb } finish { emission 1 } }
//! error: `rgb` needs a vector or a number behind it
//!  --> colour_prefix_alone.pov:5:25
//!   |
//! 5 | sphere { 0, 1 pigment { rgb } finish { emission 1 } }
//!   |                         ^^^
