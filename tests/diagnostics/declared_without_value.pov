// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration without a value
#version 3.7;
#declare A;
//! error: expected `=`, but found `;`
//!  --> declared_without_value.pov:4:11
//!   |
//! 4 | #declare A;
//!   |           ^
//! help: a name is declared with its value: #declare A = 0;
