// SPDX-License-Identifier: GPL-3.0-or-later
// A component that is not there
#version 3.7;
#declare V = <1, 2>;
#declare A = V.z;
//! error: there is no `.z` in a vector of 2
//!  --> dot_on_number.pov:5:14
//!   |
//! 5 | #declare A = V.z;
//!   |              ^^^
