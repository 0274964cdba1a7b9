// SPDX-License-Identifier: GPL-3.0-or-later
// A scene from the days when declarations had no end
#declare Radius = 2
//! error: a `;` is missing after this value
//!  --> semicolons_of_old_scene.pov:3:20
//!   |
//! 3 | #declare Radius = 2
//!   |                    ^
//! help: #declare and #local of numbers, vectors and colours end in `;`; a scene from before version 3.5 may go without, and begins with its version: #version 3.1;
#declare Height = 3
//! error: a `;` is missing after this value
//!  --> semicolons_of_old_scene.pov:4:20
//!   |
//! 4 | #declare Height = 3
//!   |                    ^
#declare Paint = rgb 1
//! error: a `;` is missing after this value
//!  --> semicolons_of_old_scene.pov:5:23
//!   |
//! 5 | #declare Paint = rgb 1
//!   |                       ^
cylinder { 0, Height*y, Radius pigment { Paint } }
