// SPDX-License-Identifier: GPL-3.0-or-later
// A value in a union
#version 3.7;
union { sphere { 0, 1 } 3 }
//! error: a number has no place in `union`
//!  --> value_in_union.pov:4:25
//!   |
//! 4 | union { sphere { 0, 1 } 3 }
//!   |                         ^
//! help: union { objects ... [modifiers] }
