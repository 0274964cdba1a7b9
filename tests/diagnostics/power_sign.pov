// SPDX-License-Identifier: GPL-3.0-or-later
// x^2
#version 3.7;
#declare X = 3;
#declare A = X ^ 2;
//! error: this character means nothing here
//!  --> power_sign.pov:5:16
//!   |
//! 5 | #declare A = X ^ 2;
//!   |                ^
//! help: a power is pow(base, exponent)
