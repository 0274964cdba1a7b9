// SPDX-License-Identifier: GPL-3.0-or-later
// A number in hexadecimal
#version 3.7;
#declare A = 0x10;
//! error: numbers are written in decimal digits
//!  --> hexadecimal.pov:4:14
//!   |
//! 4 | #declare A = 0x10;
//!   |              ^^^^
//! help: write 16
