// SPDX-License-Identifier: GPL-3.0-or-later
// An argument too few
#version 3.7;
#macro Lamp(Place, Size)
    sphere { Place, Size }
#end
Lamp(<0, 1, 0>)
//! error: macro `Lamp` takes 2 arguments, but here is 1
//!  --> macro_too_few.pov:7:1
//!   |
//! 4 | #macro Lamp(Place, Size)
//!   | ----------- defined as Lamp(Place, Size)
//! ...
//! 7 | Lamp(<0, 1, 0>)
//!   | ^^^^^^^^^^^^^^^
