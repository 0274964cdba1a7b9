// SPDX-License-Identifier: GPL-3.0-or-later
// A function outside of its domain
#version 3.7;
sphere { 0, sqrt(-2) }
//! error: there is no square root of -2
//!  --> domain.pov:4:18
//!   |
//! 4 | sphere { 0, sqrt(-2) }
//!   |                  ^^
sphere { 0, 1 translate asin(2) }
//! warning[domain]: the argument is 2; outside -1 to 1 the nearer end is taken
//!  --> domain.pov:5:30
//!   |
//! 5 | sphere { 0, 1 translate asin(2) }
//!   |                              ^
