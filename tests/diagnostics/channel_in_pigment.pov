// SPDX-License-Identifier: GPL-3.0-or-later
// A channel is no colour
#version 3.7;
sphere { 0, 1 pigment { red } }
//! error: `red` needs a number behind it
//!  --> channel_in_pigment.pov:4:25
//!   |
//! 4 | sphere { 0, 1 pigment { red } }
//!   |                         ^^^
//! help: colors.inc declares the colours Red, Green, Blue
