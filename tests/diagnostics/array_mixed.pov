// SPDX-License-Identifier: GPL-3.0-or-later
// Two kinds in an array
#version 3.7;
#declare A = array[2] { 1, "two" }
//! error: all elements of an array are of one kind: the first is a number, and this is a string
//!  --> array_mixed.pov:4:28
//!   |
//! 4 | #declare A = array[2] { 1, "two" }
//!   |                            ^^^^^
//! help: elements of several kinds can be in an `array mixed`
