// SPDX-License-Identifier: GPL-3.0-or-later
// A version that does not exist
#version 9.5;
//! error: the language has versions 1 to 3.8, but this is 9.5
//!  --> version_of_the_future.pov:3:10
//!   |
//! 3 | #version 9.5;
//!   |          ^^^
