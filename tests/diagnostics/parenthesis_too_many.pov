// SPDX-License-Identifier: GPL-3.0-or-later
// A `)` too many
#version 3.7;
#declare A = (1 + 2));
//! error: `)` closes nothing that is open
//!  --> parenthesis_too_many.pov:4:21
//!   |
//! 4 | #declare A = (1 + 2));
//!   |                     ^
