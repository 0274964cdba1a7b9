// SPDX-License-Identifier: GPL-3.0-or-later
// A number is wanted
#version 3.7;
#declare A = sqrt(<1, 2, 3>);
//! error: `sqrt` takes a number here, but this is a vector of 3
//!  --> function_of_vector.pov:4:19
//!   |
//! 4 | #declare A = sqrt(<1, 2, 3>);
//!   |                   ^^^^^^^^^
