// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a condition
#version 3.7;
#if (<1, 0, 0>) sphere { 0, 1 } #end
//! error: a condition must be a number, but it is a vector of 3
//!  --> vector_as_condition.pov:4:5
//!   |
//! 4 | #if (<1, 0, 0>) sphere { 0, 1 } #end
//!   |     ^^^^^^^^^^^
