// SPDX-License-Identifier: GPL-3.0-or-later
// A number with two points
#version 3.7;
#declare A = 1.2.3;
//! error: a number has only one point
//!  --> two_points.pov:4:14
//!   |
//! 4 | #declare A = 1.2.3;
//!   |              ^^^^^
