// SPDX-License-Identifier: GPL-3.0-or-later
// A macro without parentheses
#version 3.7;
#macro Lamp()
    sphere { 0, 1 }
#end
Lamp
//! error: `Lamp` is a macro: its call needs parentheses
//!  --> macro_called_without_parentheses.pov:7:1
//!   |
//! 7 | Lamp
//!   | ^^^^
