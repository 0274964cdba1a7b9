// SPDX-License-Identifier: GPL-3.0-or-later
// #for (I = 0; I < 10; I = I + 1)
#version 3.7;
#for (I = 0; I < 10; I = I + 1)
//! error: expected a value, `)` or `,`, but found `=`
//!  --> for_as_in_c.pov:4:9
//!   |
//! 4 | #for (I = 0; I < 10; I = I + 1)
//!   |      -  ^
//!   |      |
//!   |      opened here
//! help: a loop counts between commas: #for (I, 1, 10)
  sphere { I, 0.1 }
#end
