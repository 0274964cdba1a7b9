// SPDX-License-Identifier: GPL-3.0-or-later
// Six components
#version 3.7;
#declare V = <1, 2, 3, 4, 5, 6>;
//! error: a vector has 2 to 5 components, but this has 6
//!  --> vector_too_long.pov:4:14
//!   |
//! 4 | #declare V = <1, 2, 3, 4, 5, 6>;
//!   |              ^^^^^^^^^^^^^^^^^^
