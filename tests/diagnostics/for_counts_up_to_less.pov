// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that never runs is no error
#version 3.7;
#declare N = 0;
#for (I, 1, N)
    sphere { I, Unknown }
#end
sphere { 0, Unknown }
//! error: nothing is declared as `Unknown`
//!  --> for_counts_up_to_less.pov:8:13
//!   |
//! 8 | sphere { 0, Unknown }
//!   |             ^^^^^^^
//! help: declare it first: #declare Unknown = ...;
