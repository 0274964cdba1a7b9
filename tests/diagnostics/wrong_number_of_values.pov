// SPDX-License-Identifier: GPL-3.0-or-later
// Too few and too many values, and a vector that is too long
#version 3.7;
cylinder { <0, 0, 0>, 0.5 }
//! error: `cylinder` needs `radius`
//!  --> wrong_number_of_values.pov:4:1
//!   |
//! 4 | cylinder { <0, 0, 0>, 0.5 }
//!   | ^^^^^^^^
//! help: cylinder { base, cap, radius [open] }
sphere { <0, 0, 0>, 1, 2 }
//! error: `sphere` takes 2 values, but here is one more
//!  --> wrong_number_of_values.pov:5:24
//!   |
//! 5 | sphere { <0, 0, 0>, 1, 2 }
//!   |                        ^
//! help: sphere { centre, radius }
sphere { <1, 2, 3, 4>, 1 }
//! error: `centre` of `sphere` must be a vector of 3, but it is a vector of 4
//!  --> wrong_number_of_values.pov:6:10
//!   |
//! 6 | sphere { <1, 2, 3, 4>, 1 }
//!   |          ^^^^^^^^^^^^ this is a vector of 4
//! help: sphere { centre, radius }   centre: vector
sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1> }
//! error: `matrix` needs 12 numbers, but it has 9
//!  --> wrong_number_of_values.pov:7:15
//!   |
//! 7 | sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1> }
//!   |               ^^^^^^
//! help: matrix <xx, xy, xz, yx, yy, yz, zx, zy, zz, tx, ty, tz>: where the axes go, and the translation; those of the inverse may follow
