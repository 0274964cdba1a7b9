// SPDX-License-Identifier: GPL-3.0-or-later
// A string as a vector
#version 3.7;
sphere { 0, 1 translate "up" }
//! error: `translate` of `sphere` must be a vector of 3, but it is a string
//!  --> translate_in_string.pov:4:25
//!   |
//! 4 | sphere { 0, 1 translate "up" }
//!   |                         ^^^^ this is a string
//! help: sphere { ... translate v ... }   translate: vector, default 0
