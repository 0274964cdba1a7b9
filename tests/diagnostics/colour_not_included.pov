// SPDX-License-Identifier: GPL-3.0-or-later
// A colour whose file is not included
#version 3.7;
sphere { 0, 1 pigment { color Red } }
//! error: nothing is declared as `Red`
//!  --> colour_not_included.pov:4:31
//!   |
//! 4 | sphere { 0, 1 pigment { color Red } }
//!   |                               ^^^
//! help: declare it first: #declare Red = ...;
