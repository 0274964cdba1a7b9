// SPDX-License-Identifier: GPL-3.0-or-later
// A number as text needs its form
#version 3.7;
#debug str(3)
//! error: `str` takes 3 arguments, but here is 1
//!  --> str_of_one.pov:4:8
//!   |
//! 4 | #debug str(3)
//!   |        ^^^^^^
//! help: str(x, width, digits): a number as text
