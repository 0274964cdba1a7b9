// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has letters beyond ASCII
#version 3.7;
#include "grün.inc"
//! error: there is no file `grün.inc`
//!  --> include_umlaut.pov:4:10
//!   |
//! 4 | #include "grün.inc"
//!   |          ^^^^^^^^^^
//!   |
//!   = looked in the current directory
