// SPDX-License-Identifier: GPL-3.0-or-later
// #endif
#version 3.7;
#if (1)
  sphere { 0, 1 }
#endif
//! error: there is no directive `#endif`
//!  --> endif.pov:6:1
//!   |
//! 6 | #endif
//!   | ^^^^^^
//! help: did you mean `#end`?
