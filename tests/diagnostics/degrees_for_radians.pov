// SPDX-License-Identifier: GPL-3.0-or-later
// sin takes radians: no error, but both names exist
#version 3.7;
#declare A = sin(90 deg);
//! error: expected `)` or `,`, but found `deg`
//!  --> degrees_for_radians.pov:4:21
//!   |
//! 4 | #declare A = sin(90 deg);
//!   |                 -   ^^^
//!   |                 |
//!   |                 opened here
