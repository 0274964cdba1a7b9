// SPDX-License-Identifier: GPL-3.0-or-later
// #for I = 1 to 10 ... #end
#version 3.7;
#for I = 1 to 10
//! error: expected `(`, but found `I`
//!  --> for_without_parentheses.pov:4:6
//!   |
//! 4 | #for I = 1 to 10
//!   |      ^
//! help: a loop counts in parentheses: #for (I, 1, 10)
  sphere { I, 0.1 }
#end
