// SPDX-License-Identifier: GPL-3.0-or-later
// A vector in the wrong brackets
#version 3.7;
#declare A = (1, 2, 3);
//! error: values in parentheses are no vector
//!  --> vector_in_parentheses.pov:4:14
//!   |
//! 4 | #declare A = (1, 2, 3);
//!   |              ^^^^^^^^^
//! help: a vector is written between `<` and `>`: <1, 2, 3>
sphere { A, 1 }
