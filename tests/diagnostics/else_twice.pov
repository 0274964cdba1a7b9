// SPDX-License-Identifier: GPL-3.0-or-later
// Two #else
#version 3.7;
#if (0) #else #else #end
//! error: `#else` cannot follow `#else`
//!  --> else_twice.pov:4:15
//!   |
//! 4 | #if (0) #else #else #end
//!   | ---           ^^^^^
//!   | |
//!   | of this directive
