// SPDX-License-Identifier: GPL-3.0-or-later
// #if (A and B)
#version 3.7;
#declare A = 1;
#if (A and A) sphere { 0, 1 } #end
//! error: expected `)`, but found `and`
//!  --> and_as_word.pov:5:8
//!   |
//! 5 | #if (A and A) sphere { 0, 1 } #end
//!   |     -  ^^^
//!   |     |
//!   |     opened here
//! help: `and` is written as a sign: (A & B)
