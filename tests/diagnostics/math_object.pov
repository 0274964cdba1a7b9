// SPDX-License-Identifier: GPL-3.0-or-later
// Functions belong to no object
#version 3.7;
#declare A = Math.sin(3);
//! error: expected a part of a vector or a colour, but found `sin`
//!  --> math_object.pov:4:19
//!   |
//! 4 | #declare A = Math.sin(3);
//!   |                   ^^^
//! help: parts are x y z t, u v, red green blue filter transmit, gray: V.x
