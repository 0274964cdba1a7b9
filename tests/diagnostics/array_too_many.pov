// SPDX-License-Identifier: GPL-3.0-or-later
// Values are left over
#version 3.7;
#declare A = array[2] { 1, 2, 3 }
//! error: here are 3 elements for a dimension of 2
//!  --> array_too_many.pov:4:23
//!   |
//! 4 | #declare A = array[2] { 1, 2, 3 }
//!   |                       ^^^^^^^^^^^
