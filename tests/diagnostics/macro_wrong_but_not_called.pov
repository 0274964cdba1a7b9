// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong in a macro is told of where it is called, and only then
#version 3.7;
#macro Unused() sphere { 0, 1 +* 2 } #end
#macro Used(A) sphere { 0, A +* 2 } #end
//! error: expected a value, but found `*`
//!  --> macro_wrong_but_not_called.pov:5:31
//!   |
//! 5 | #macro Used(A) sphere { 0, A +* 2 } #end
//!   |                               ^
//!   |
//!   = in macro `Used`, called at macro_wrong_but_not_called.pov:6:1
//! help: an operator needs a value on both sides
Used(3)
