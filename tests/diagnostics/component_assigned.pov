// SPDX-License-Identifier: GPL-3.0-or-later
// A component cannot be set
#version 3.7;
#declare V = <1, 2, 3>;
#declare V.x = 2;
//! error: expected `=`, but found `.`
//!  --> component_assigned.pov:5:11
//!   |
//! 5 | #declare V.x = 2;
//!   |           ^
//! help: parts of a vector are not set alone: #declare V = <2, V.y, V.z>;
