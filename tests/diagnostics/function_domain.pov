// SPDX-License-Identifier: GPL-3.0-or-later
// Not defined for these
#version 3.7;
#declare A = sqrt(-1);
//! error: there is no square root of -1
//!  --> function_domain.pov:4:19
//!   |
//! 4 | #declare A = sqrt(-1);
//!   |                   ^^
#declare B = ln(0);
//! error: there is no logarithm of 0
//!  --> function_domain.pov:5:17
//!   |
//! 5 | #declare B = ln(0);
//!   |                 ^
