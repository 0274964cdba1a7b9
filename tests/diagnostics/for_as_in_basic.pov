// SPDX-License-Identifier: GPL-3.0-or-later
// A loop as in other languages
#version 3.7;
#for I = 1 to 10
//! error: expected `(`, but found `I`
//!  --> for_as_in_basic.pov:4:6
//!   |
//! 4 | #for I = 1 to 10
//!   |      ^
//! help: a loop counts in parentheses: #for (I, 1, 10)
