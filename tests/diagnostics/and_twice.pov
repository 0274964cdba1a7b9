// SPDX-License-Identifier: GPL-3.0-or-later
// The && of other languages
#version 3.7;
#if (1 && 1) sphere { 0, 1 } #end
//! error: this language writes `&`, not `&&`
//!  --> and_twice.pov:4:8
//!   |
//! 4 | #if (1 && 1) sphere { 0, 1 } #end
//!   |        ^^
//! help: write `&`
