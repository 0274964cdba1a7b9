// SPDX-License-Identifier: GPL-3.0-or-later
// A digit in front
#version 3.7;
#declare 2nd = 2;
//! error: expected a name or `(`, but found `2`
//!  --> name_with_digit_first.pov:4:10
//!   |
//! 4 | #declare 2nd = 2;
//!   |          ^
//! help: a name begins with a letter or `_`
