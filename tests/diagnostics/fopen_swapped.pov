// SPDX-License-Identifier: GPL-3.0-or-later
// The name of the file first
#version 3.7;
#fopen "a.txt" F write
//! error: expected a name, but found `"a.txt"`
//!  --> fopen_swapped.pov:4:8
//!   |
//! 4 | #fopen "a.txt" F write
//!   |        ^^^^^^^
//! help: the name of the open file comes first: #fopen File "data.txt" write
