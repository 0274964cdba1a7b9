// SPDX-License-Identifier: GPL-3.0-or-later
// A power as in other languages
#version 3.7;
#declare A = 2**3;
//! error: expected a value, but found `*`
//!  --> power_by_stars.pov:4:16
//!   |
//! 4 | #declare A = 2**3;
//!   |                ^
//! help: a power is pow(base, exponent)
