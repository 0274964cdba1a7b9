// SPDX-License-Identifier: GPL-3.0-or-later
// The counter of a loop
#version 3.7;
#for (I, 1, 3)
    sphere { <J, 0, 0>, 1 }
//! error: nothing is declared as `J`
//!  --> loop_counter_misspelt.pov:5:15
//!   |
//! 5 |     sphere { <J, 0, 0>, 1 }
//!   |               ^
//! help: declare it first: #declare J = ...;
#end
