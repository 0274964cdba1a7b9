// SPDX-License-Identifier: GPL-3.0-or-later
// #if (not I)
#version 3.7;
#declare I = 1;
#if (not I) sphere { 0, 1 } #end
//! error: expected `)`, but found `I`
//!  --> not_as_word.pov:5:10
//!   |
//! 5 | #if (not I) sphere { 0, 1 } #end
//!   |     -    ^
//!   |     |
//!   |     opened here
//! help: `not` is written as a sign: (!A)
