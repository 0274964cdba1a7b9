// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison outside of parentheses
#version 3.7;
#declare A = 1 < 2;
//! error: expected a value, `,` or `>`, but found `;`
//!  --> comparison_without_parentheses.pov:4:19
//!   |
//! 4 | #declare A = 1 < 2;
//!   |                   ^
//! help: a vector ends in `>`; comparisons are written in parentheses: (a < b)
