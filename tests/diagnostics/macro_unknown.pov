// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that does not exist
#version 3.7;
#macro Lamp(Place)
    sphere { Place, 1 }
#end
Lmap(0)
//! error: nothing is declared as `Lmap`
//!  --> macro_unknown.pov:7:1
//!   |
//! 7 | Lmap(0)
//!   | ^^^^
//! help: did you mean `Lamp`?
