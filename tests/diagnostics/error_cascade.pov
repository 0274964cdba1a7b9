// SPDX-License-Identifier: GPL-3.0-or-later
// One mistake in a macro is said once
#version 3.7;
#macro M(A)
    sphere { A, Nothing }
//! error: nothing is declared as `Nothing`
//!  --> error_cascade.pov:5:17
//!   |
//! 5 |     sphere { A, Nothing }
//!   |                 ^^^^^^^
//!   |
//!   = in macro `M`, called at error_cascade.pov:8:5
//! help: declare it first: #declare Nothing = ...;
#end
#for (I, 1, 5)
    M(I)
#end
