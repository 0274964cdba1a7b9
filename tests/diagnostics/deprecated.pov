// SPDX-License-Identifier: GPL-3.0-or-later
// A directive without its sign, as old scenes write it
#version 3.7;
declare Size = 2;
//! warning[deprecated]: `declare` should have a # before it
//!  --> deprecated.pov:4:1
//!   |
//! 4 | declare Size = 2;
//!   | ^^^^^^^
//! help: write `#declare`
sphere { 0, Size }
