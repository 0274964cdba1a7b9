// SPDX-License-Identifier: GPL-3.0-or-later
// A `;` as in C
#version 3.7;
sphere { 0, 1 };
//! warning[semicolon]: this `;` has no effect
//!  --> semicolon_after_object.pov:4:16
//!   |
//! 4 | sphere { 0, 1 };
//!   |                ^
//! help: `;` ends a #declare of numbers and nothing else
box { 0, 1 };
//! warning[semicolon]: this `;` has no effect
//!  --> semicolon_after_object.pov:5:13
//!   |
//! 5 | box { 0, 1 };
//!   |             ^
//! help: `;` ends a #declare of numbers and nothing else
