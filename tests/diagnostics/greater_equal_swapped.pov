// SPDX-License-Identifier: GPL-3.0-or-later
// Signs in the wrong order
#version 3.7;
#declare A = 1; #if (A => 1) #debug "x" #end
//! error: expected a value, but found `>`
//!  --> greater_equal_swapped.pov:4:25
//!   |
//! 4 | #declare A = 1; #if (A => 1) #debug "x" #end
//!   |                         ^
//! help: `>=` is greater or equal: (a >= b)
