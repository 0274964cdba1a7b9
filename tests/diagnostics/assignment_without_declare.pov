// SPDX-License-Identifier: GPL-3.0-or-later
// A value without #declare
#version 3.7;
Radius = 2;
//! error: `=` does not fit here
//!  --> assignment_without_declare.pov:4:8
//!   |
//! 4 | Radius = 2;
//!   |        ^
//! help: a name gets a value by `#declare Name = value;`
sphere { 0, Radius }
