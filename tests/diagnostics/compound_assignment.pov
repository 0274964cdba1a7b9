// SPDX-License-Identifier: GPL-3.0-or-later
// i += 1
#version 3.7;
#declare I = 0;
#declare I += 1;
//! error: expected `=`, but found `+`
//!  --> compound_assignment.pov:5:12
//!   |
//! 5 | #declare I += 1;
//!   |            ^
//! help: a value is changed by `#declare I = I + 1;`
