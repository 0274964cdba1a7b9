// SPDX-License-Identifier: GPL-3.0-or-later
// A word of finish misspelt
#version 3.7;
sphere { 0, 1 finish { specualr 0.5 } }
//! error: `finish` has no word `specualr`
//!  --> finish_misspelt.pov:4:24
//!   |
//! 4 | sphere { 0, 1 finish { specualr 0.5 } }
//!   |                        ^^^^^^^^
//! help: did you mean `specular`?
