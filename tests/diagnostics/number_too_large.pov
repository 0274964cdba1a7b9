// SPDX-License-Identifier: GPL-3.0-or-later
// A number beyond what there is
#version 3.7;
#declare A = 1e999;
sphere { 0, A }
//! error: `radius` of `sphere` must be finite, but it is inf
//!  --> number_too_large.pov:5:13
//!   |
//! 5 | sphere { 0, A }
//!   |             ^ this is inf
//! help: sphere { centre, radius }   radius: number, whose sign does not count
