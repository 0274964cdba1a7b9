// SPDX-License-Identifier: GPL-3.0-or-later
// A block without its braces
#version 3.7;
background rgb 1
//! error: what belongs to `background` stands in braces
//!  --> background_without_braces.pov:4:1
//!   |
//! 4 | background rgb 1
//!   | ^^^^^^^^^^
//! help: write `background { ... }`
