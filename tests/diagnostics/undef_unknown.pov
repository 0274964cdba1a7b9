// SPDX-License-Identifier: GPL-3.0-or-later
// #undef of nothing
#version 3.7;
#undef Nothing
//! warning[unknown-name]: nothing is declared as `Nothing`
//!  --> undef_unknown.pov:4:8
//!   |
//! 4 | #undef Nothing
//!   |        ^^^^^^^
