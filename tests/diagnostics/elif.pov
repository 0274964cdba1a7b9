// SPDX-License-Identifier: GPL-3.0-or-later
// The word of other languages
#version 3.7;
#if (1 > 2)
#elif (1)
//! error: there is no directive `#elif`
//!  --> elif.pov:5:1
//!   |
//! 5 | #elif (1)
//!   | ^^^^^
//! help: did you mean `#elseif`?
    sphere { 0, 1 }
#end
