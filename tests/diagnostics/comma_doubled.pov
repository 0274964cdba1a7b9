// SPDX-License-Identifier: GPL-3.0-or-later
// Two commas
#version 3.7;
sphere { <0,, 1>, 1 }
//! error: two commas in a row
//!  --> comma_doubled.pov:4:13
//!   |
//! 4 | sphere { <0,, 1>, 1 }
//!   |             ^
//! help: leave one out, or put the missing value between them
