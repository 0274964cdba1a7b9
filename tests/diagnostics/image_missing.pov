// SPDX-License-Identifier: GPL-3.0-or-later
// A picture that is not there
#version 3.7;
sphere { 0, 1 pigment { image_map { png "nothing.png" } } }
//! error: there is no file `nothing.png`
//!  --> image_missing.pov:4:41
//!   |
//! 4 | sphere { 0, 1 pigment { image_map { png "nothing.png" } } }
//!   |                                         ^^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
