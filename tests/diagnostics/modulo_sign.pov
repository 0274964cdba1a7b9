// SPDX-License-Identifier: GPL-3.0-or-later
// a % b
#version 3.7;
#declare A = 7 % 2;
//! error: this character means nothing here
//!  --> modulo_sign.pov:4:16
//!   |
//! 4 | #declare A = 7 % 2;
//!   |                ^
//! help: the remainder of a division is mod(a, b), its whole part div(a, b)
