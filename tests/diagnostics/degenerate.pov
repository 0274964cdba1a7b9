// SPDX-License-Identifier: GPL-3.0-or-later
// Things without extent
#version 3.7;
camera { location y look_at y }
//! error: `look_at` must not be the camera's own location
//!  --> degenerate.pov:4:1
//!   |
//! 4 | camera { location y look_at y }
//!   | ^^^^^^
//! help: camera { perspective [location v] [direction v] [right v] [up v] [sky v] [look_at v] [aperture n] ... }
cylinder { 0, 0, 1 }
//! error: a `cylinder` needs two different end points
//!  --> degenerate.pov:5:1
//!   |
//! 5 | cylinder { 0, 0, 1 }
//!   | ^^^^^^^^
//! help: cylinder { base, cap, radius [open] }
triangle { 0, x, 2*x }
//! warning[degenerate]: this `triangle` is left out: its corners are on one line
//!  --> degenerate.pov:6:1
//!   |
//! 6 | triangle { 0, x, 2*x }
//!   | ^^^^^^^^
sphere { 0, 1 scale <1, 0, 1> }
//! warning[degenerate]: this `scale` is 0 along an axis, which is taken as 1
//!  --> degenerate.pov:7:21
//!   |
//! 7 | sphere { 0, 1 scale <1, 0, 1> }
//!   |                     ^^^^^^^^^
sphere { 0, 1 matrix <1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0> }
//! error: this `matrix` makes everything flat
//!  --> degenerate.pov:8:15
//!   |
//! 8 | sphere { 0, 1 matrix <1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0> }
//!   |               ^^^^^^
//! help: its first three rows are where the axes go: they must not lie in one plane
ovus { 0, 0 }
//! warning[degenerate]: this `ovus` is left out: its radii are 0
//!  --> degenerate.pov:9:1
//!   |
//! 9 | ovus { 0, 0 }
//!   | ^^^^
