// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that comes later in the file
#version 3.7;
M(3)
//! error: nothing is declared as `M`
//!  --> macro_used_before.pov:4:1
//!   |
//! 4 | M(3)
//!   | ^
//! 5 | #macro M(A) A #end
//!   | -------- declared only here
#macro M(A) A #end
