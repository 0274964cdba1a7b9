// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter with the name of something else
#version 3.7;
#declare R = 2; #declare F = function(R) { R*2 }
//! error: `R` is declared already; a parameter needs a name of its own
//!  --> function_parameter_declared.pov:4:39
//!   |
//! 4 | #declare R = 2; #declare F = function(R) { R*2 }
//!   |                                       ^
