// SPDX-License-Identifier: GPL-3.0-or-later
// A `}` too many
#version 3.7;
sphere { 0, 1 } }
//! error: `}` closes nothing that is open
//!  --> brace_too_many.pov:4:17
//!   |
//! 4 | sphere { 0, 1 } }
//!   |                 ^
box { 0, 1 }
