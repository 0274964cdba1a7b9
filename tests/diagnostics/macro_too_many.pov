// SPDX-License-Identifier: GPL-3.0-or-later
// An argument too many
#version 3.7;
#macro Lamp(Place)
    sphere { Place, 1 }
#end
Lamp(<0, 1, 0>, 2)
//! error: macro `Lamp` takes 1 argument, but here are 2
//!  --> macro_too_many.pov:7:1
//!   |
//! 4 | #macro Lamp(Place)
//!   | ----------- defined as Lamp(Place)
//! ...
//! 7 | Lamp(<0, 1, 0>, 2)
//!   | ^^^^^^^^^^^^^^^^^^
