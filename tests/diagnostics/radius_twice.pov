// SPDX-License-Identifier: GPL-3.0-or-later
// A value too many
#version 3.7;
sphere { <0, 1, 0>, 1, 2 }
//! error: `sphere` takes 2 values, but here is one more
//!  --> radius_twice.pov:4:24
//!   |
//! 4 | sphere { <0, 1, 0>, 1, 2 }
//!   |                        ^
//! help: sphere { centre, radius }
