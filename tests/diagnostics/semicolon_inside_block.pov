// SPDX-License-Identifier: GPL-3.0-or-later
// A `;` between the items of a block
#version 3.7;
sphere { 0, 1;
//! warning[semicolon]: this `;` has no effect
//!  --> semicolon_inside_block.pov:4:14
//!   |
//! 4 | sphere { 0, 1;
//!   |              ^
//! help: `;` ends a #declare of numbers and nothing else
    pigment { rgb 1 };
//! warning[semicolon]: this `;` has no effect
//!  --> semicolon_inside_block.pov:5:22
//!   |
//! 5 |     pigment { rgb 1 };
//!   |                      ^
//! help: `;` ends a #declare of numbers and nothing else
}
