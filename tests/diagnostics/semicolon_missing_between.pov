// SPDX-License-Identifier: GPL-3.0-or-later
// A #declare runs into the next
#version 3.7;
#declare A = 1
//! error: a `;` is missing after this value
//!  --> semicolon_missing_between.pov:4:15
//!   |
//! 4 | #declare A = 1
//!   |               ^
//! help: #declare and #local of numbers, vectors and colours end in `;`
#declare B = 2;
