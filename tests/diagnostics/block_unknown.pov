// SPDX-License-Identifier: GPL-3.0-or-later
// A block of another language
#version 3.7;
cube { 0, 1 }
//! error: `cube` has no place in a scene
//!  --> block_unknown.pov:4:1
//!   |
//! 4 | cube { 0, 1 }
//!   | ^^^^
//!   |
//!   = it belongs in `julia_fractal`
