// SPDX-License-Identifier: GPL-3.0-or-later
// A function does not know itself yet
#version 3.7;
#declare F = function(n) { select(n, 0, n*F(n-1)) }
//! error: nothing is declared as `F`
//!  --> function_calls_itself.pov:4:43
//!   |
//! 4 | #declare F = function(n) { select(n, 0, n*F(n-1)) }
//!   |                                           ^^^^^^
//! help: a name has no value in its own declaration; only macros call themselves
