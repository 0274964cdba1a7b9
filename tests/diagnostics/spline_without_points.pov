// SPDX-License-Identifier: GPL-3.0-or-later
// A number without its point
#version 3.7;
#declare S = spline { linear_spline 0 }
//! error: this t has no point: spline { 0, <1, 2, 3> 1, ... }
//!  --> spline_without_points.pov:4:37
//!   |
//! 4 | #declare S = spline { linear_spline 0 }
//!   |                                     ^
