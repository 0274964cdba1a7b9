// SPDX-License-Identifier: GPL-3.0-or-later
// #ifdef Name ... #end
#version 3.7;
#ifdef Foo sphere { 0, 1 } #end
//! error: expected `(`, but found `Foo`
//!  --> ifdef_without_parentheses.pov:4:8
//!   |
//! 4 | #ifdef Foo sphere { 0, 1 } #end
//!   |        ^^^
//! help: the name stands in parentheses: #ifdef (Name)
