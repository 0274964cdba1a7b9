// SPDX-License-Identifier: GPL-3.0-or-later
// Too many components of a colour
#version 3.7;
sphere { 0, 1 pigment { rgb <1, 2, 3, 4, 5, 6> } }
//! error: a vector has 2 to 5 components, but this has 6
//!  --> rgb_of_six.pov:4:29
//!   |
//! 4 | sphere { 0, 1 pigment { rgb <1, 2, 3, 4, 5, 6> } }
//!   |                             ^^^^^^^^^^^^^^^^^^
