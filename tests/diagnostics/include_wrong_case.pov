// SPDX-License-Identifier: GPL-3.0-or-later
// Another case of letters
#version 3.7;
#include "Parts.inc"
//! error: there is no file `Parts.inc`
//!  --> include_wrong_case.pov:4:10
//!   |
//! 4 | #include "Parts.inc"
//!   |          ^^^^^^^^^^^
//!   |
//!   = looked in the current directory
