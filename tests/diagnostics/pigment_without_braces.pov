// SPDX-License-Identifier: GPL-3.0-or-later
// pigment Name
#version 3.7;
#declare C = rgb <1, 0, 0>;
sphere { 0, 1 pigment C }
//! error: what belongs to `pigment` stands in braces
//!  --> pigment_without_braces.pov:5:15
//!   |
//! 5 | sphere { 0, 1 pigment C }
//!   |               ^^^^^^^
//! help: write `pigment { C }`
