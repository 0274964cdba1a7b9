// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has a per cent sign
#version 3.7;
#include "100%.inc"
//! error: there is no file `100%.inc`
//!  --> include_percent.pov:4:10
//!   |
//! 4 | #include "100%.inc"
//!   |          ^^^^^^^^^^
//!   |
//!   = looked in the current directory
