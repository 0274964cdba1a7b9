// SPDX-License-Identifier: GPL-3.0-or-later
// A hyphen in a name
#version 3.7;
#declare Lamp-Height = 2;
//! error: expected `=`, but found `-`
//!  --> name_with_hyphen.pov:4:14
//!   |
//! 4 | #declare Lamp-Height = 2;
//!   |              ^
//! help: a name cannot have a `-`, but it can have a `_`
