// SPDX-License-Identifier: GPL-3.0-or-later
// V[0]
#version 3.7;
#declare V = <1, 2, 3>;
#declare M = V[0];
//! error: only arrays have elements, and this is a vector of 3
//!  --> element_of_vector.pov:5:14
//!   |
//! 5 | #declare M = V[0];
//!   |              ^^^^
//! help: the parts of a vector V are V.x, V.y and V.z
