// SPDX-License-Identifier: GPL-3.0-or-later
// A plane without direction
#version 3.7;
plane { 0, 1 }
//! error: a `plane` needs a normal with a length above 0 and below 1e150
//!  --> plane_no_normal.pov:4:1
//!   |
//! 4 | plane { 0, 1 }
//!   | ^^^^^
//! help: plane { normal, distance }
