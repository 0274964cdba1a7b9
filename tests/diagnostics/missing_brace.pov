// SPDX-License-Identifier: GPL-3.0-or-later
// A block that is not closed
#version 3.7;
union {
//! error: `{` has no end
//!  --> missing_brace.pov:4:7
//!   |
//! 4 | union {
//!   |       ^
//! 5 |     sphere { <0, 0, 0>, 1 pigment { rgb 1 }
//!   |            - perhaps this one is meant:
//! 6 |     box { 0, 1 }
//! 7 | }
//!   | - this `}` stands further left
    sphere { <0, 0, 0>, 1 pigment { rgb 1 }
    box { 0, 1 }
}
plane { y, 0 }
