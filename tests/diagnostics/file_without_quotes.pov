// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a file without quotes
#version 3.7;
sphere { 0, 1 pigment { image_map { png Wreath.png } } }
//! error: nothing is declared as `Wreath`
//!  --> file_without_quotes.pov:4:41
//!   |
//! 4 | sphere { 0, 1 pigment { image_map { png Wreath.png } } }
//!   |                                         ^^^^^^
//! help: the name of a file stands in quotes: "Wreath.png"
