// SPDX-License-Identifier: GPL-3.0-or-later
// The #end of the inner #if is missing
#version 3.7;
#for (I, 1, 3)
//! error: `#for` has no `#end`
//!  --> end_missing_in_loop.pov:4:1
//!   |
//! 4 | #for (I, 1, 3)
//!   | ^^^^
//! 5 |     #if (I > 1)
//!   |     --- perhaps this one is meant:
//! 6 |         sphere { I, 1 }
//! 7 | #end
//!   | ---- this `#end` stands further left
    #if (I > 1)
        sphere { I, 1 }
#end
box { 0, 1 }
