// SPDX-License-Identifier: GPL-3.0-or-later
// A dash instead of a minus
#version 3.7;
sphere { <0, –1, 0>, 1 }
//! error: this is a dash
//!  --> minus_of_a_word_processor.pov:4:14
//!   |
//! 4 | sphere { <0, –1, 0>, 1 }
//!   |              ^
//! help: write `-`
