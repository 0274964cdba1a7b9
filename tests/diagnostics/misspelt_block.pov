// SPDX-License-Identifier: GPL-3.0-or-later
// A block of the scene with a letter too few
#version 3.7;
sphre { 0, 1 }
//! error: a scene has no word `sphre`
//!  --> misspelt_block.pov:4:1
//!   |
//! 4 | sphre { 0, 1 }
//!   | ^^^^^
//! help: did you mean `sphere`?
sphere { 0, 1 }
