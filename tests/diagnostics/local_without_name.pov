// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration without a name
#version 3.7;
#local = 3;
//! error: expected a name or `(`, but found `=`
//!  --> local_without_name.pov:4:8
//!   |
//! 4 | #local = 3;
//!   |        ^
//! help: the name comes before the `=`: #declare Name = value;
