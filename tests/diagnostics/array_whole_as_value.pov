// SPDX-License-Identifier: GPL-3.0-or-later
// An array where a number is wanted
#version 3.7;
#declare A = array[2] { 1, 2 }
sphere { 0, A }
//! error: `radius` of `sphere` must be a number, but it is an array
//!  --> array_whole_as_value.pov:5:13
//!   |
//! 5 | sphere { 0, A }
//!   |             ^ this is an array
//! help: sphere { centre, radius }   radius: number, whose sign does not count
