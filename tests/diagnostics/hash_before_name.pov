// SPDX-License-Identifier: GPL-3.0-or-later
// A # before the name of what was declared
#version 3.7;
#declare Tower = union { sphere { 0, 1 } box { -1, <1, 0, 1> } }
object { #Tower scale 2 }
//! warning[syntax]: this `#` has no effect, for `Tower` is no directive
//!  --> hash_before_name.pov:5:10
//!   |
//! 5 | object { #Tower scale 2 }
//!   |          ^
#Tower
//! warning[syntax]: this `#` has no effect, for `Tower` is no directive
//!  --> hash_before_name.pov:6:1
//!   |
//! 6 | #Tower
//!   | ^
#Tauer
//! error: there is no directive `#Tauer`
//!  --> hash_before_name.pov:7:1
//!   |
//! 7 | #Tauer
//!   | ^^^^^^
