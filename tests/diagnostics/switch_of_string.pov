// SPDX-License-Identifier: GPL-3.0-or-later
// #switch of a string
#version 3.7;
#switch ("a")
//! error: what #switch looks at must be a number, but it is a string
//!  --> switch_of_string.pov:4:9
//!   |
//! 4 | #switch ("a")
//!   |         ^^^^^
    #case ("a")
        sphere { 0, 1 }
#end
