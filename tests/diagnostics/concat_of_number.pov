// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are no strings
#version 3.7;
#debug concat("a", 3)
//! error: `concat` takes a string here, but this is a number
//!  --> concat_of_number.pov:4:20
//!   |
//! 4 | #debug concat("a", 3)
//!   |                    ^
//! help: str(x, 0, 2) is the number x as a string
