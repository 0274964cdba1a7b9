// SPDX-License-Identifier: GPL-3.0-or-later
// #include of a number
#version 3.7;
#include 3
//! error: #include takes the name of a file, but this is a number
//!  --> include_number.pov:4:10
//!   |
//! 4 | #include 3
//!   |          ^
