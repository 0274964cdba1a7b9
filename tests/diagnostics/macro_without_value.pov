// SPDX-License-Identifier: GPL-3.0-or-later
// A macro whose value is wanted and that has none
#version 3.7;
#macro Twice(A)
    #local B = 2 * A;
#end
#declare C = Twice(2);
//! error: a value is wanted here, and this macro gives none
//!  --> macro_without_value.pov:7:14
//!   |
//! 7 | #declare C = Twice(2);
//!   |              ^^^^^^^^
//! help: a macro gives what stands in it without a directive: #macro Twice(A) (2*A) #end
