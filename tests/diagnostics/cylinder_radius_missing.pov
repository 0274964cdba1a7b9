// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of a cylinder
#version 3.7;
cylinder { 0, y }
//! error: `cylinder` needs `radius`
//!  --> cylinder_radius_missing.pov:4:1
//!   |
//! 4 | cylinder { 0, y }
//!   | ^^^^^^^^
//! help: cylinder { base, cap, radius [open] }
