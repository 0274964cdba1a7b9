// SPDX-License-Identifier: GPL-3.0-or-later
// A block misspelt
#version 3.7;
lightsource { y, rgb 1 }
//! error: a scene has no word `lightsource`
//!  --> light_misspelt.pov:4:1
//!   |
//! 4 | lightsource { y, rgb 1 }
//!   | ^^^^^^^^^^^
//! help: did you mean `light_source`?
