// SPDX-License-Identifier: GPL-3.0-or-later
// A file that does not exist
#version 3.7;
#include "nothing_like_this.inc"
//! error: there is no file `nothing_like_this.inc`
//!  --> include_missing.pov:4:10
//!   |
//! 4 | #include "nothing_like_this.inc"
//!   |          ^^^^^^^^^^^^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
