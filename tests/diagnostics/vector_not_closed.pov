// SPDX-License-Identifier: GPL-3.0-or-later
// A vector without `>`
#version 3.7;
sphere { <0, 1, 0, 1 }
//! error: expected a value, `,` or `>`, but found `}`
//!  --> vector_not_closed.pov:4:22
//!   |
//! 4 | sphere { <0, 1, 0, 1 }
//!   |                      ^
//! help: a vector ends in `>`; comparisons are written in parentheses: (a < b)
box { 0, 1 }
