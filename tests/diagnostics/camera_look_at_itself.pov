// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that looks at itself
#version 3.7;
camera { location y look_at y }
//! error: `look_at` must not be the camera's own location
//!  --> camera_look_at_itself.pov:4:1
//!   |
//! 4 | camera { location y look_at y }
//!   | ^^^^^^
//! help: camera { perspective [location v] [direction v] [right v] [up v] [sky v] [look_at v] [aperture n] ... }
