// SPDX-License-Identifier: GPL-3.0-or-later
// A file that is not there
#version 3.7;
#include "colours.inc"
//! error: there is no file `colours.inc`
//!  --> missing_include.pov:4:10
//!   |
//! 4 | #include "colours.inc"
//!   |          ^^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
sphere { 0, 1 }
