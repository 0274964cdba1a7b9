// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has an equals sign
#version 3.7;
#include "size=2.inc"
//! error: there is no file `size=2.inc`
//!  --> include_equals.pov:4:10
//!   |
//! 4 | #include "size=2.inc"
//!   |          ^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
