// SPDX-License-Identifier: GPL-3.0-or-later
// An error three macros deep
#version 3.7;
#macro Bulb(Size)
    sphere { 0, Size }
//! error: `radius` of `sphere` must be a number, but it is a string
//!  --> macro_error_inside.pov:5:17
//!   |
//! 5 |     sphere { 0, Size }
//!   |                 ^^^^ this is a string
//!   |
//!   = in macro `Bulb`, called at macro_error_inside.pov:8:5
//!   = in macro `Lamp`, called at macro_error_inside.pov:12:9
//!   = in macro `Street`, called at macro_error_inside.pov:15:1
//! help: sphere { centre, radius }   radius: number, whose sign does not count
#end
#macro Lamp(Size)
    Bulb(Size)
#end
#macro Street(Size)
    #for (I, 1, 2)
        Lamp(Size)
    #end
#end
Street("big")
