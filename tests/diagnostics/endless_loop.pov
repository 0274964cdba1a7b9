// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that never ends
#version 3.7;
#declare I = 0;
#while (I < 10)
//! error: this scene takes more than 20000 passes of loops and calls of macros, which is the limit
//!  --> endless_loop.pov:5:8
//!   |
//! 5 | #while (I < 10)
//!   |        ^^^^^^^^
//! help: something in a loop must make its condition false, or #break; --limit-steps raises the limit
    sphere { I*x, 1 }
#end
