// SPDX-License-Identifier: GPL-3.0-or-later
// Two cameras
#version 3.7;
camera { location y }
camera { location z }
//! warning[duplicate]: there is a camera before this one; the last one counts
//!  --> camera_twice.pov:5:1
//!   |
//! 5 | camera { location z }
//!   | ^^^^^^
