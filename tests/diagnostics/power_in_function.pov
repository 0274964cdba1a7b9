// SPDX-License-Identifier: GPL-3.0-or-later
// x^2 in a function: only the sign is wrong
#version 3.7;
isosurface { function { x^2 + y*y - 1 } contained_by { box { -1, 1 } } }
//! error: this character means nothing here
//!  --> power_in_function.pov:4:26
//!   |
//! 4 | isosurface { function { x^2 + y*y - 1 } contained_by { box { -1, 1 } } }
//!   |                          ^
//! help: a power is pow(base, exponent)
