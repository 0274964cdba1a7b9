// SPDX-License-Identifier: GPL-3.0-or-later
// A #case outside of #switch
#version 3.7;
#case (1)
//! error: `#case` belongs between `#switch` and its `#end`, and none is open
//!  --> case_alone.pov:4:1
//!   |
//! 4 | #case (1)
//!   | ^^^^^
    sphere { 0, 1 }
