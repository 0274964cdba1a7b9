// SPDX-License-Identifier: GPL-3.0-or-later
// Things in the wrong place
#version 3.7;
finish { ambient 1 }
//! error: `finish` has no place in a scene
//!  --> misplaced.pov:4:1
//!   |
//! 4 | finish { ambient 1 }
//!   | ^^^^^^
//!   |
//!   = it belongs in `texture`
sphere { 0, 1 location x }
//! error: `location` has no place in `sphere`
//!  --> misplaced.pov:5:15
//!   |
//! 5 | sphere { 0, 1 location x }
//!   |               ^^^^^^^^
//!   |
//!   = it belongs in `camera`
//! help: sphere { centre, radius }
union { sphere { 0, 1 } translate x box { 0, 1 } }
//! error: the objects of `union` come before what changes the whole
//!  --> misplaced.pov:6:37
//!   |
//! 6 | union { sphere { 0, 1 } translate x box { 0, 1 } }
//!   |                                     ^^^^^^^^^^^^
object { sphere { 0, 1 } sphere { x, 1 } }
//! error: `object` holds one object, and this is a second
//!  --> misplaced.pov:7:26
//!   |
//! 7 | object { sphere { 0, 1 } sphere { x, 1 } }
//!   |                          ^^^^^^^^^^^^^^^
//! help: union { ... } holds several objects
camera { location -z orthographic }
//! error: the type `orthographic` must come first in `camera`
//!  --> misplaced.pov:8:22
//!   |
//! 8 | camera { location -z orthographic }
//!   |                      ^^^^^^^^^^^^
//! help: camera { orthographic [location v] [direction v] [right v] [up v] [sky v] [look_at v] [aperture n] [blur_samples n[, n]] [focal_point v] [variance n] [confidence n] [shutter n[, n]] [angle n] }
sphere { 0, 1 pigment { rgb 1 rgb 0 } }
//! error: a pigment has one colour or one pattern, and this is a second
//!  --> misplaced.pov:9:31
//!   |
//! 9 | sphere { 0, 1 pigment { rgb 1 rgb 0 } }
//!   |                               ^^^^^
//! help: pigment { rgb <r, g, b> }, or pigment { pattern [color_map { [0 rgb ...] [1 rgb ...] }] }
5
//! error: a number has no place in a scene
//!   --> misplaced.pov:10:1
//!    |
//! 10 | 5
//!    | ^
