// SPDX-License-Identifier: GPL-3.0-or-later
// The count says more than there are
#version 3.7;
polygon { 4, <0,0>, <1,0>, <1,1> }
//! error: `points` of `polygon` are counted as 4, but there are only 3
//!  --> polygon_too_few.pov:4:1
//!   |
//! 4 | polygon { 4, <0,0>, <1,0>, <1,1> }
//!   | ^^^^^^^
//! help: polygon { count, points, ... }
