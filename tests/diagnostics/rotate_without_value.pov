// SPDX-License-Identifier: GPL-3.0-or-later
// A transformation without value
#version 3.7;
sphere { 0, 1 rotate }
//! error: `rotate` of `sphere` needs a vector
//!  --> rotate_without_value.pov:4:15
//!   |
//! 4 | sphere { 0, 1 rotate }
//!   |               ^^^^^^
//! help: sphere { ... rotate v ... }   rotate: vector, default 0
