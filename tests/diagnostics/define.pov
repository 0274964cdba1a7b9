// SPDX-License-Identifier: GPL-3.0-or-later
// A directive of another language
#version 3.7;
#define A 3
//! error: there is no directive `#define`
//!  --> define.pov:4:1
//!   |
//! 4 | #define A 3
//!   | ^^^^^^^
//! help: did you mean `#declare`?
//! error: expected `=`, but found `3`
//!  --> define.pov:4:11
//!   |
//! 4 | #define A 3
//!   |           ^
