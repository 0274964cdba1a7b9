// SPDX-License-Identifier: GPL-3.0-or-later
// A loop without an end
#version 3.7;
#for (I, 10) #end
//! error: a #for needs a name, a start and an end: #for(i, 1, 10)
//!  --> for_of_two.pov:4:1
//!   |
//! 4 | #for (I, 10) #end
//!   | ^^^^^^^^^^^^^^^^^
