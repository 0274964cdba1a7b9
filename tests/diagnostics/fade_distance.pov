// SPDX-License-Identifier: GPL-3.0-or-later
// A length below 0
#version 3.7;
sphere { 0, 1 pigment { rgbt 1 } interior { fade_distance -2 fade_power 1 } }
//! warning[no-effect]: `fade_distance` of `interior` should be at least 0, but it is -2: 0 counts
//!  --> fade_distance.pov:4:59
//!   |
//! 4 | sphere { 0, 1 pigment { rgbt 1 } interior { fade_distance -2 fade_power 1 } }
//!   |                                                           ^^
//! help: interior { ... fade_distance n ... }   fade_distance: number from 0 on, default 0
