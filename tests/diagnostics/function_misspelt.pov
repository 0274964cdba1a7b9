// SPDX-License-Identifier: GPL-3.0-or-later
// A function that does not exist
#version 3.7;
#declare A = sine(1);
//! error: nothing is declared as `sine`
//!  --> function_misspelt.pov:4:14
//!   |
//! 4 | #declare A = sine(1);
//!   |              ^^^^
//! help: did you mean `sin`?
