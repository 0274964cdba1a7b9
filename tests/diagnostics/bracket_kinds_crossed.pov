// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets of two kinds
#version 3.7;
#declare A = array[2} { 1, 2 };
//! error: `}` closes nothing that is open
//!  --> bracket_kinds_crossed.pov:4:21
//!   |
//! 4 | #declare A = array[2} { 1, 2 };
//!   |                   - ^
//!   |                   |
//!   |                   the innermost that is open
//! error: expected `]`, but found `{`
//!  --> bracket_kinds_crossed.pov:4:23
//!   |
//! 4 | #declare A = array[2} { 1, 2 };
//!   |                       ^
