// SPDX-License-Identifier: GPL-3.0-or-later
// No such character
#version 3.7;
#declare A = chr(-1);
//! error: a character's code is from 0 to 65535, but this is -1
//!  --> chr_out_of_range.pov:4:18
//!   |
//! 4 | #declare A = chr(-1);
//!   |                  ^^
