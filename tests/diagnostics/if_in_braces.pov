// SPDX-License-Identifier: GPL-3.0-or-later
// #if {1}
#version 3.7;
#if {1} sphere { 0, 1 pigment { rgb 1 } } #end
//! error: expected `(`, but found `{`
//!  --> if_in_braces.pov:4:5
//!   |
//! 4 | #if {1} sphere { 0, 1 pigment { rgb 1 } } #end
//!   |     ^
//! help: a condition stands in parentheses: (a > b)
