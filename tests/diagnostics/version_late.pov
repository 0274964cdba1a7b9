// SPDX-License-Identifier: GPL-3.0-or-later
// The newest version behind another statement
#declare A = 1;
#version 3.8;
//! error: `#version 3.8` must be the first statement of the scene: what stands before it would be read by the rules of an older version
//!  --> version_late.pov:4:10
//!   |
//! 4 | #version 3.8;
//!   |          ^^^
//! help: put it above everything but comments
sphere { 0, 1 }
