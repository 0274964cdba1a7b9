// SPDX-License-Identifier: GPL-3.0-or-later
// A #for without end
#version 3.7;
#for (I, 1)
//! error: a #for needs a name, a start and an end: #for(i, 1, 10)
//!  --> for_without_end_value.pov:4:1
//!   |
//! 4 | #for (I, 1)
//!   | ^^^^^^^^^^^ to line 6
    sphere { I, 1 }
#end
