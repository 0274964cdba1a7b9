// SPDX-License-Identifier: GPL-3.0-or-later
// A path of another system
#version 3.7;
#include "lib\parts.inc"
//! error: there is no file `lib\parts.inc`
//!  --> include_backslash.pov:4:10
//!   |
//! 4 | #include "lib\parts.inc"
//!   |          ^^^^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
//! help: folders are separated by `/`: "lib/parts.inc"
