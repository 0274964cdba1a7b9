// SPDX-License-Identifier: GPL-3.0-or-later
// A string that does not end
#version 3.7;
#declare A = "one;
#declare B = "two";
//! error: this string has no end
//!  --> string_not_closed.pov:5:18
//!   |
//! 4 | #declare A = "one;
//!   |              - or this one, which goes on over the end of its line
//! 5 | #declare B = "two";
//!   |                  ^
//! help: a string ends at the next `"`
