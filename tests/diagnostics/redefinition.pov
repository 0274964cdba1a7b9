// SPDX-License-Identifier: GPL-3.0-or-later
// A macro cannot become a number
#version 3.7;
#macro Size() 1 #end
#declare Size = 2;
//! error: `Size` is a macro and cannot become something else
//!  --> redefinition.pov:5:10
//!   |
//! 5 | #declare Size = 2;
//!   |          ^^^^
