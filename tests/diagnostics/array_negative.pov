// SPDX-License-Identifier: GPL-3.0-or-later
// An index below 0
#version 3.7;
#declare A = array[3] { 1, 2, 3 }
#declare B = A[-1];
//! error: the index must be from 0 to 2, but it is -1
//!  --> array_negative.pov:5:16
//!   |
//! 5 | #declare B = A[-1];
//!   |                ^^
