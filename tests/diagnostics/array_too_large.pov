// SPDX-License-Identifier: GPL-3.0-or-later
// An array with too many elements
#version 3.7;
#declare A = array[1e6][1e6];
//! error: an array has at most 100000000 elements
//!  --> array_too_large.pov:4:14
//!   |
//! 4 | #declare A = array[1e6][1e6];
//!   |              ^^^^^^^^^^^^^^^
//! help: --limit-elements raises the limit
