// SPDX-License-Identifier: GPL-3.0-or-later
// #debug of a number
#version 3.7;
#declare I = 3;
#debug I
//! error: a message is a string, but this is a number
//!  --> debug_number.pov:5:8
//!   |
//! 5 | #debug I
//!   |        ^
//! help: str(x, 0, 3) and vstr(3, v, ",", 0, 3) make strings of numbers
