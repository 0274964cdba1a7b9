// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says itself
#version 3.7;
#warning "the lamps are very bright"
//! warning[user-warning]: the lamps are very bright
//!  --> user_messages.pov:4:1
//!   |
//! 4 | #warning "the lamps are very bright"
//!   | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
#declare Depth = 12;
#if (Depth > 10)
    #error concat("Depth is at most 10, but it is ", str(Depth, 0, 0))
//! error: Depth is at most 10, but it is 12
//!  --> user_messages.pov:7:5
//!   |
//! 7 |     #error concat("Depth is at most 10, but it is ", str(Depth, 0, 0))
//!   |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
#end
sphere { 0, -1 }
