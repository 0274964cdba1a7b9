// SPDX-License-Identifier: GPL-3.0-or-later
// A word without its block
#version 3.7;
sphere
//! error: what belongs to `sphere` stands in braces
//!  --> word_alone.pov:4:1
//!   |
//! 4 | sphere
//!   | ^^^^^^
//! help: write `sphere { ... }`
box { 0, 1 }
