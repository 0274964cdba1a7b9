// SPDX-License-Identifier: GPL-3.0-or-later
// A scale of 0
#version 3.7;
sphere { 0, 1 scale <1, 0, 1> }
//! warning[degenerate]: this `scale` is 0 along an axis, which is taken as 1
//!  --> scale_zero.pov:4:21
//!   |
//! 4 | sphere { 0, 1 scale <1, 0, 1> }
//!   |                     ^^^^^^^^^
