// SPDX-License-Identifier: GPL-3.0-or-later
// Quotes of a word processor
#version 3.7;
#include “colors.inc”
//! error: this is a typographic quote
//!  --> string_curly_quotes.pov:4:10
//!   |
//! 4 | #include “colors.inc”
//!   |          ^
//! help: write `"`
