// SPDX-License-Identifier: GPL-3.0-or-later
// #print
#version 3.7;
#print "hello"
//! error: there is no directive `#print`
//!  --> print_directive.pov:4:1
//!   |
//! 4 | #print "hello"
//!   | ^^^^^^
//! help: did you mean `#debug`?
