// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends at the same place
#version 3.7;
cylinder { y, y, 1 }
//! error: a `cylinder` needs two different end points
//!  --> cylinder_flat.pov:4:1
//!   |
//! 4 | cylinder { y, y, 1 }
//!   | ^^^^^^^^
//! help: cylinder { base, cap, radius [open] }
