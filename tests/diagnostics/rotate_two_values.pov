// SPDX-License-Identifier: GPL-3.0-or-later
// A transformation with two values
#version 3.7;
sphere { 0, 1 rotate 45, y }
//! error: this value belongs to nothing
//!  --> rotate_two_values.pov:4:26
//!   |
//! 4 | sphere { 0, 1 rotate 45, y }
//!   |                          ^
//! help: write `rotate y*45`
