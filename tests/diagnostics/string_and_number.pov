// SPDX-License-Identifier: GPL-3.0-or-later
// A number where a string is wanted
#version 3.7;
#declare I = 3;
#debug concat("frame ", I)
//! error: `concat` takes a string here, but this is a number
//!  --> string_and_number.pov:5:25
//!   |
//! 5 | #debug concat("frame ", I)
//!   |                         ^
//! help: str(x, 0, 2) is the number x as a string
