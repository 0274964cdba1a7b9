// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration of a number without its semicolon
#version 3.7;
#declare Radius = 2
//! error: a `;` is missing after this value
//!  --> semicolon.pov:4:20
//!   |
//! 4 | #declare Radius = 2
//!   |                    ^
//! help: #declare and #local of numbers, vectors and colours end in `;`
sphere { 0, Radius }
