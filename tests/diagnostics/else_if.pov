// SPDX-License-Identifier: GPL-3.0-or-later
// #else if (...)
#version 3.7;
#declare X = 1;
#if (X = 1)
  sphere { 0, 1 }
#else if (X = 2)
//! error: `#else if` is one word
//!  --> else_if.pov:7:1
//!   |
//! 7 | #else if (X = 2)
//!   | ^^^^^^^^
//! help: write `#elseif`, which has the `#end` of its `#if`
  sphere { 0, 2 }
#end
