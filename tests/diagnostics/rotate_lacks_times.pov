// SPDX-License-Identifier: GPL-3.0-or-later
// rotate y 45
#version 3.7;
sphere { 0, 1 rotate y 45 }
//! error: this value belongs to nothing
//!  --> rotate_lacks_times.pov:4:24
//!   |
//! 4 | sphere { 0, 1 rotate y 45 }
//!   |                        ^^
//! help: write `rotate y*45`
