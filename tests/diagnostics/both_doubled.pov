// SPDX-License-Identifier: GPL-3.0-or-later
// A && B outside of parentheses
#version 3.7;
#declare B = true && false;
//! error: this language writes `&`, not `&&`
//!  --> both_doubled.pov:4:19
//!   |
//! 4 | #declare B = true && false;
//!   |                   ^^
//! help: write `&`
