// SPDX-License-Identifier: GPL-3.0-or-later
// A percent sign
#version 3.7;
sphere { 0, 50% }
//! error: this character means nothing here
//!  --> percent.pov:4:15
//!   |
//! 4 | sphere { 0, 50% }
//!   |               ^
//! help: the remainder of a division is mod(a, b), its whole part div(a, b)
