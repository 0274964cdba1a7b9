// SPDX-License-Identifier: GPL-3.0-or-later
// An angle that does not exist
#version 3.7;
camera { angle 180 }
//! error: `angle` of a flat picture must be below 180 degrees
//!  --> camera_angle.pov:4:1
//!   |
//! 4 | camera { angle 180 }
//!   | ^^^^^^
//! help: camera { perspective [location v] [direction v] [right v] [up v] [sky v] [look_at v] [aperture n] ... }
