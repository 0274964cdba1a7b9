// SPDX-License-Identifier: GPL-3.0-or-later
// Objects in objects without end
#version 3.7;
#macro Branch(Length)
    union {
        cylinder { 0, Length*y, 0.1 }
//! error: a `cylinder` needs two different end points
//!  --> endless_nesting.pov:6:9
//!   |
//! 6 |         cylinder { 0, Length*y, 0.1 }
//!   |         ^^^^^^^^
//!   |
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = ... 3528 more
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:11:1
//! help: cylinder { base, cap, radius [open] }
        object { Branch(Length*0.9) rotate 20*z }
//! error: objects are nested more than 10000 deep
//!  --> endless_nesting.pov:7:9
//!   |
//! 7 |         object { Branch(Length*0.9) rotate 20*z }
//!   |         ^^^^^^
//!   |
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = ... 4991 more
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:7:18
//!   = in macro `Branch`, called at endless_nesting.pov:11:1
//! help: give the parts to one `union` instead of wrapping each in the next; --limit-nesting allows more
        object { Branch(Length*0.9) rotate -20*z }
    }
#end
Branch(1)
