// SPDX-License-Identifier: GPL-3.0-or-later
// Strings are not added
#version 3.7;
#declare A = "one" + "two";
//! error: `+` cannot join a string and a string
//!  --> string_added.pov:4:14
//!   |
//! 4 | #declare A = "one" + "two";
//!   |              ^^^^^^^^^^^^^
//! help: strings are joined by concat(a, b)
