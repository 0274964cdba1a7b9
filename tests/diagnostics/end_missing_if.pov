// SPDX-License-Identifier: GPL-3.0-or-later
// An #if without #end
#version 3.7;
#if (1)
//! error: `#if` has no `#end`
//!  --> end_missing_if.pov:4:1
//!   |
//! 4 | #if (1)
//!   | ^^^
sphere { 0, 1 }
#declare A = 2;
