// SPDX-License-Identifier: GPL-3.0-or-later
// A string is no array
#version 3.7;
#declare S = "abc"; #declare C = S[0];
//! error: only arrays have elements, and this is a string
//!  --> letter_of_string.pov:4:34
//!   |
//! 4 | #declare S = "abc"; #declare C = S[0];
//!   |                                  ^^^^
//! help: substr(S, 1, 1) is the first letter of a string
