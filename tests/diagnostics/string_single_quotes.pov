// SPDX-License-Identifier: GPL-3.0-or-later
// A string in '
#version 3.7;
#declare A = 'one';
//! error: this is a single quote
//!  --> string_single_quotes.pov:4:14
//!   |
//! 4 | #declare A = 'one';
//!   |              ^
//! help: write `"`
