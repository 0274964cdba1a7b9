// SPDX-License-Identifier: GPL-3.0-or-later
// checker of colours without colors.inc
#version 3.7;
plane { y, 0 pigment { checker Red, White } }
//! error: nothing is declared as `Red`
//!  --> checker_of_undeclared.pov:4:32
//!   |
//! 4 | plane { y, 0 pigment { checker Red, White } }
//!   |                                ^^^
//! help: declare it first: #declare Red = ...;
//! error: nothing is declared as `White`
//!  --> checker_of_undeclared.pov:4:37
//!   |
//! 4 | plane { y, 0 pigment { checker Red, White } }
//!   |                                     ^^^^^
//! help: declare it first: #declare White = ...;
