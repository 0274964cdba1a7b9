// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that never ends
#version 3.7;
#macro Branch(Length)
    sphere { Length*y, 0.1 }
    Branch(Length + 1)
//! error: macros call each other 10000 deep, which is the limit
//!  --> endless_recursion.pov:6:5
//!   |
//! 6 |     Branch(Length + 1)
//!   |     ^^^^^^^^^^^^^^^^^^
//!   |
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = ... 9990 more
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:6:5
//!   = in macro `Branch`, called at endless_recursion.pov:8:1
//! help: a recursion needs an #if that ends it; --limit-depth raises the limit
#end
Branch(1)
