// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of the base comes before the cap
#version 3.7;
cone { <0,0,0>, <0,1,0>, 1, 0 }
//! error: `base_radius` of `cone` must be a number, but it is a vector of 3
//!  --> cone_as_cylinder.pov:4:17
//!   |
//! 4 | cone { <0,0,0>, <0,1,0>, 1, 0 }
//!   |                 ^^^^^^^ this is a vector of 3
//! help: cone { base, base_radius, cap, cap_radius [open] }   base_radius: number
