// SPDX-License-Identifier: GPL-3.0-or-later
// A corner is missing
#version 3.7;
box { <0, 0, 0> }
//! error: `box` needs `corner2`
//!  --> box_one_corner.pov:4:1
//!   |
//! 4 | box { <0, 0, 0> }
//!   | ^^^
//! help: box { corner1, corner2 }
