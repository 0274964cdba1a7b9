// SPDX-License-Identifier: GPL-3.0-or-later
// A word of a block with an equals sign
#version 3.7;
sphere { 0, 1 finish { ambient = 1 } }
//! error: `=` does not fit here
//!  --> equals_in_block.pov:4:32
//!   |
//! 4 | sphere { 0, 1 finish { ambient = 1 } }
//!   |                                ^
//! help: the words of a block have no `=`: radius 2
