// SPDX-License-Identifier: GPL-3.0-or-later
// An #else without #if
#version 3.7;
#else
//! error: `#else` belongs between `#if` and its `#end`, and none is open
//!  --> else_alone.pov:4:1
//!   |
//! 4 | #else
//!   | ^^^^^
sphere { 0, 1 }
