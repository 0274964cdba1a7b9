// SPDX-License-Identifier: GPL-3.0-or-later
// An @
#version 3.7;
#declare A = @2;
//! error: this character means nothing here
//!  --> at_sign.pov:4:14
//!   |
//! 4 | #declare A = @2;
//!   |              ^
