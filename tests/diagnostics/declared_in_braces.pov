// SPDX-License-Identifier: GPL-3.0-or-later
// Ball { ... }
#version 3.7;
#declare Ball = sphere { 0, 1 }
Ball { translate y }
//! error: a scene has no word `Ball`
//!  --> declared_in_braces.pov:5:1
//!   |
//! 5 | Ball { translate y }
//!   | ^^^^
//! help: write `object { Ball ... }`
