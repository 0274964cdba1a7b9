// SPDX-License-Identifier: GPL-3.0-or-later
// A local of a macro that has ended
#version 3.7;
#macro M()
    #local Size = 2;
    sphere { 0, Size }
#end
M()
sphere { 0, Size }
//! error: nothing is declared as `Size`
//!  --> local_gone.pov:9:13
//!   |
//! 9 | sphere { 0, Size }
//!   |             ^^^^
//! help: declare it first: #declare Size = ...;
