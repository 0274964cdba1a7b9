// SPDX-License-Identifier: GPL-3.0-or-later
// A vector in the brackets of another language
#version 3.7;
sphere { [0,0,0], 1 }
//! error: an entry in brackets has no place in `sphere`
//!  --> vector_in_square_brackets.pov:4:10
//!   |
//! 4 | sphere { [0,0,0], 1 }
//!   |          ^^^^^^^
//! help: a vector is written between `<` and `>`: <1, 2, 3>
