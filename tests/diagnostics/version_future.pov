// SPDX-License-Identifier: GPL-3.0-or-later
// A version that is not there yet
#version 4.2;
//! error: the language has versions 1 to 3.8, but this is 4.2
//!  --> version_future.pov:3:10
//!   |
//! 3 | #version 4.2;
//!   |          ^^^
sphere { 0, 1 }
