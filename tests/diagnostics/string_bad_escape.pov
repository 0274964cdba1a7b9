// SPDX-License-Identifier: GPL-3.0-or-later
// An escape that does not exist
#version 3.7;
#declare A = "C:\data\new";
//! error: a string has no such escape
//!  --> string_bad_escape.pov:4:17
//!   |
//! 4 | #declare A = "C:\data\new";
//!   |                 ^^
//! help: known are \a \b \f \n \r \t \v \' \" \\ and \uXXXX; a backslash itself is \\
