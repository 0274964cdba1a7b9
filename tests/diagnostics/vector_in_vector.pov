// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a component
#version 3.7;
#declare A = <1, 2, 3>;
sphere { <A, 0, 0>, 1 }
//! error: a component of a vector is a number, but this is a vector of 3
//!  --> vector_in_vector.pov:5:11
//!   |
//! 5 | sphere { <A, 0, 0>, 1 }
//!   |           ^
