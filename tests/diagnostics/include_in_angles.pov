// SPDX-License-Identifier: GPL-3.0-or-later
// #include <colors.inc>
#version 3.7;
#include <colors.inc>
//! error: the name of a file stands in quotes: #include "colors.inc"
//!  --> include_in_angles.pov:4:10
//!   |
//! 4 | #include <colors.inc>
//!   |          ^^^^^^^^^^^^
sphere { 0, 1 pigment { Red } }
