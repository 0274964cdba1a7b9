// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a pigment
#version 3.7;
sphere { 0, 1 pigment { <1, 0, 0> } }
//! error: expected a colour, but this is a vector of 3
//!  --> vector_as_pigment.pov:4:25
//!   |
//! 4 | sphere { 0, 1 pigment { <1, 0, 0> } }
//!   |                         ^^^^^^^^^
//! help: write `rgb <1, 0, 0>`
