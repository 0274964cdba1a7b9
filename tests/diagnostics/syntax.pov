// SPDX-License-Identifier: GPL-3.0-or-later
// Text that no rule fits
#version 3.7;
sphere { <0, 1 * , 2>, 1 }
//! error: expected a value, but found `,`
//!  --> syntax.pov:4:18
//!   |
//! 4 | sphere { <0, 1 * , 2>, 1 }
//!   |                  ^
