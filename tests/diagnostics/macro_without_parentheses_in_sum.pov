// SPDX-License-Identifier: GPL-3.0-or-later
// A macro is no variable
#version 3.7;
#macro M() 3 #end
#declare C = M + 1;
//! error: `M` is a macro: its call needs parentheses
//!  --> macro_without_parentheses_in_sum.pov:5:14
//!   |
//! 5 | #declare C = M + 1;
//!   |              ^
