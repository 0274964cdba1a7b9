// SPDX-License-Identifier: GPL-3.0-or-later
// #include without quotes
#version 3.7;
#include colors.inc
//! error: the name of a file stands in quotes: #include "colors.inc"
//!  --> include_without_quotes.pov:4:10
//!   |
//! 4 | #include colors.inc
//!   |          ^^^^^^^^^^
