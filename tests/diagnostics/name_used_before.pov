// SPDX-License-Identifier: GPL-3.0-or-later
// Used before it is declared
#version 3.7;
sphere { 0, Radius }
//! error: nothing is declared as `Radius`
//!  --> name_used_before.pov:4:13
//!   |
//! 4 | sphere { 0, Radius }
//!   |             ^^^^^^
//! 5 | #declare Radius = 1;
//!   | --------------- declared only here
#declare Radius = 1;
