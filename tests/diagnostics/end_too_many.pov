// SPDX-License-Identifier: GPL-3.0-or-later
// An #end too many
#version 3.7;
#if (1) #end
#end
//! error: `#end` closes nothing that is open
//!  --> end_too_many.pov:5:1
//!   |
//! 5 | #end
//!   | ^^^^
sphere { 0, 1 }
