// SPDX-License-Identifier: GPL-3.0-or-later
// scale <2, 1>
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 }
sphere { 0, 1 scale <2, 1> }
//! warning[degenerate]: this `scale` is 0 along an axis, which is taken as 1
//!  --> scale_of_two.pov:6:21
//!   |
//! 6 | sphere { 0, 1 scale <2, 1> }
//!   |                     ^^^^^^
//! help: a vector of 2 has 0 for its third number
