// SPDX-License-Identifier: GPL-3.0-or-later
// A comma before the first component
#version 3.7;
sphere { <, 0, 1>, 1 }
//! error: expected a value, but found `,`
//!  --> vector_comma_at_start.pov:4:11
//!   |
//! 4 | sphere { <, 0, 1>, 1 }
//!   |           ^
