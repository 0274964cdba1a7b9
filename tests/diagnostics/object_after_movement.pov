// SPDX-License-Identifier: GPL-3.0-or-later
// An object behind what moves all of them
#version 3.7;
#declare S = sphere { 0, 1 }
union { S translate x S }
//! error: the objects of `union` come before what changes the whole
//!  --> object_after_movement.pov:5:23
//!   |
//! 5 | union { S translate x S }
//!   |                       ^
