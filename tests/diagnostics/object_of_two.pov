// SPDX-License-Identifier: GPL-3.0-or-later
// Two objects where one is wanted
#version 3.7;
object { sphere { 0, 1 } box { 0, 1 } }
//! error: `object` holds one object, and this is a second
//!  --> object_of_two.pov:4:26
//!   |
//! 4 | object { sphere { 0, 1 } box { 0, 1 } }
//!   |                          ^^^^^^^^^^^^
//! help: union { ... } holds several objects
