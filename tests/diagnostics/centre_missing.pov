// SPDX-License-Identifier: GPL-3.0-or-later
// The centre is missing
#version 3.7;
sphere { 1 }
//! error: `sphere` needs `radius`
//!  --> centre_missing.pov:4:1
//!   |
//! 4 | sphere { 1 }
//!   | ^^^^^^
//! help: sphere { centre, radius }
