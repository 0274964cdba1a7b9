// SPDX-License-Identifier: GPL-3.0-or-later
// A macro without #end
#version 3.7;
#macro M(A)
//! error: `#macro` has no `#end`
//!  --> end_missing_macro.pov:4:1
//!   |
//! 4 | #macro M(A)
//!   | ^^^^^^
    sphere { A, 1 }
M(0)
