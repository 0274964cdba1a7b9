// SPDX-License-Identifier: GPL-3.0-or-later
// A division by zero
#version 3.7;
#declare Columns = 0;
sphere { <10/Columns, 0, 0>, 1 }
//! warning[division-by-zero]: division by zero; the result is infinite
//!  --> division_by_zero.pov:5:14
//!   |
//! 5 | sphere { <10/Columns, 0, 0>, 1 }
//!   |              ^^^^^^^ this is 0
//! error: `centre` of `sphere` must be finite, but it is inf
//!  --> division_by_zero.pov:5:10
//!   |
//! 5 | sphere { <10/Columns, 0, 0>, 1 }
//!   |          ^^^^^^^^^^^^^^^^^^ this is inf
//! help: sphere { centre, radius }   centre: vector
