// SPDX-License-Identifier: GPL-3.0-or-later
// The radius is missing
#version 3.7;
sphere { <0, 1, 0> }
//! error: `sphere` needs `radius`
//!  --> radius_missing.pov:4:1
//!   |
//! 4 | sphere { <0, 1, 0> }
//!   | ^^^^^^
//! help: sphere { centre, radius }
