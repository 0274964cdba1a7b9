// SPDX-License-Identifier: GPL-3.0-or-later
// Braces around a condition
#version 3.7;
#if {1} sphere { 0, 1 } #end
//! error: expected `(`, but found `{`
//!  --> brace_for_parenthesis.pov:4:5
//!   |
//! 4 | #if {1} sphere { 0, 1 } #end
//!   |     ^
//! help: a condition stands in parentheses: (a > b)
