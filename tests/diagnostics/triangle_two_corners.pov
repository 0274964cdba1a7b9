// SPDX-License-Identifier: GPL-3.0-or-later
// A corner is missing
#version 3.7;
triangle { 0, x }
//! error: `triangle` needs `corner3`
//!  --> triangle_two_corners.pov:4:1
//!   |
//! 4 | triangle { 0, x }
//!   | ^^^^^^^^
//! help: triangle { corner1, corner2, corner3 }
