// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked at without parentheses
#version 3.7;
#declare A = 1;
#switch A #case (1) #break #end
//! error: expected `(`, but found `A`
//!  --> switch_without_parentheses.pov:5:9
//!   |
//! 5 | #switch A #case (1) #break #end
//!   |         ^
//! help: what is looked at stands in parentheses: #switch (A) #case (1)
