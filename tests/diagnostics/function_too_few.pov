// SPDX-License-Identifier: GPL-3.0-or-later
// A function with too few arguments
#version 3.7;
#declare A = atan2(1);
//! error: `atan2` takes 2 arguments, but here is 1
//!  --> function_too_few.pov:4:14
//!   |
//! 4 | #declare A = atan2(1);
//!   |              ^^^^^^^^
//! help: atan2(y, x): angle of the point (x, y), in radians
