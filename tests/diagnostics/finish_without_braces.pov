// SPDX-License-Identifier: GPL-3.0-or-later
// finish ambient 0.3
#version 3.7;
sphere { 0, 1 finish ambient 0.3 }
//! error: what belongs to `finish` stands in braces
//!  --> finish_without_braces.pov:4:15
//!   |
//! 4 | sphere { 0, 1 finish ambient 0.3 }
//!   |               ^^^^^^
//! help: write `finish { ... }`
