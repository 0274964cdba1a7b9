// SPDX-License-Identifier: GPL-3.0-or-later
// Values are missing
#version 3.7;
#declare A = array[3] { 1, 2 }
//! error: here are 2 elements for a dimension of 3
//!  --> array_too_few.pov:4:23
//!   |
//! 4 | #declare A = array[3] { 1, 2 }
//!   |                       ^^^^^^^^
