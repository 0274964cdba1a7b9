// SPDX-License-Identifier: GPL-3.0-or-later
// Characters beyond the end
#version 3.7;
#declare A = substr("abc", 2, 5);
//! error: from 2 on the string has 2 characters, but the length is 5
//!  --> substr_beyond.pov:4:31
//!   |
//! 4 | #declare A = substr("abc", 2, 5);
//!   |                               ^
