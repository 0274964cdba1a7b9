// SPDX-License-Identifier: GPL-3.0-or-later
// A matrix without a translation
#version 3.7;
sphere { 0, 1 matrix <1,0,0, 0,1,0, 0,0,1> }
//! error: `matrix` needs 12 numbers, but it has 9
//!  --> matrix_of_nine.pov:4:15
//!   |
//! 4 | sphere { 0, 1 matrix <1,0,0, 0,1,0, 0,0,1> }
//!   |               ^^^^^^
//! help: matrix <xx, xy, xz, yx, yy, yz, zx, zy, zz, tx, ty, tz>: where the axes go, and the translation; those of the inverse may follow
