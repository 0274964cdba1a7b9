// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that makes no pass
#version 3.7;
#declare Count = 0;
camera { location <0, 0, -9> look_at 0 }
light_source { <9, 9, -9>, 1 }
union {
//! warning[no-effect]: there is no object in this `union`
//!  --> union_of_nothing.pov:7:1
//!   |
//! 7 | union {
//!   | ^^^^^
    #for (I, 1, Count)
        sphere { I * x, 1 }
    #end
}
sphere { 0, 1 }
