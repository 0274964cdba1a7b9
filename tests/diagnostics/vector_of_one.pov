// SPDX-License-Identifier: GPL-3.0-or-later
// One component
#version 3.7;
#declare V = <1>;
//! error: a vector has 2 to 5 components, but this has 1
//!  --> vector_of_one.pov:4:14
//!   |
//! 4 | #declare V = <1>;
//!   |              ^^^
