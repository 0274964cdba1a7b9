// SPDX-License-Identifier: GPL-3.0-or-later
// A comma in a number
#version 3.7;
#declare A = 1,5;
//! error: a number is written with a point, not with a comma
//!  --> decimal_comma.pov:4:14
//!   |
//! 4 | #declare A = 1,5;
//!   |              ^^^
//! help: write 1.5
