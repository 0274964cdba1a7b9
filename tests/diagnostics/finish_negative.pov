// SPDX-License-Identifier: GPL-3.0-or-later
// A value out of range
#version 3.7;
sphere { 0, 1 finish { roughness 0 } }
//! warning[no-effect]: `roughness` of `finish` should be above 0, but it is 0: 0.0001 counts
//!  --> finish_negative.pov:4:34
//!   |
//! 4 | sphere { 0, 1 finish { roughness 0 } }
//!   |                                  ^
//! help: finish { ... roughness n ... }   roughness: number above 0, default 0.05
