// SPDX-License-Identifier: GPL-3.0-or-later
// A macro without a list of parameters
#version 3.7;
#macro Lamp sphere { 0, 1 } #end
//! error: expected `(`, but found `sphere`
//!  --> macro_without_parentheses.pov:4:13
//!   |
//! 4 | #macro Lamp sphere { 0, 1 } #end
//!   |             ^^^^^^
//! help: parameters stand in parentheses: #macro Name(A, B)
