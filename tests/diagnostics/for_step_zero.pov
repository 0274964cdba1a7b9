// SPDX-License-Identifier: GPL-3.0-or-later
// A step of 0
#version 3.7;
#for (I, 1, 3, 0)
//! error: the step of this #for is 0, so it would not end
//!  --> for_step_zero.pov:4:1
//!   |
//! 4 | #for (I, 1, 3, 0)
//!   | ^^^^^^^^^^^^^^^^^ to line 6
    sphere { I, 1 }
#end
