// SPDX-License-Identifier: GPL-3.0-or-later
// A string without its end
#version 3.7;
#debug "hello
//! error: this string has no end
//!  --> unterminated.pov:4:8
//!   |
//! 4 | #debug "hello
//!   |        ^
//! help: a string ends at the next `"`
sphere { 0, 1 }
