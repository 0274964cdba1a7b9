// SPDX-License-Identifier: GPL-3.0-or-later
// What follows a word without braces is not told of again
#version 3.7;
camera location <0,0,-5> look_at 0
//! error: what belongs to `camera` stands in braces
//!  --> camera_without_braces.pov:4:1
//!   |
//! 4 | camera location <0,0,-5> look_at 0
//!   | ^^^^^^
//! help: write `camera { ... }`
