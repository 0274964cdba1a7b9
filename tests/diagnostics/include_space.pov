// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has a blank
#version 3.7;
#include "my parts.inc"
//! error: there is no file `my parts.inc`
//!  --> include_space.pov:4:10
//!   |
//! 4 | #include "my parts.inc"
//!   |          ^^^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
