// SPDX-License-Identifier: GPL-3.0-or-later
// A word of camera misspelt
#version 3.7;
camera { location y lookat 0 }
//! error: `camera` has no word `lookat`
//!  --> camera_misspelt.pov:4:21
//!   |
//! 4 | camera { location y lookat 0 }
//!   |                     ^^^^^^
//! help: did you mean `look_at`?
