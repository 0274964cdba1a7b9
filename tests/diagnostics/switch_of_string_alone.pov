// SPDX-License-Identifier: GPL-3.0-or-later
// A switch without a case
#version 3.7;
#switch (3) "x" #end
//! error: only directives can stand between a #switch and its first #case
//!  --> switch_of_string_alone.pov:4:13
//!   |
//! 4 | #switch (3) "x" #end
//!   |             ^^^
