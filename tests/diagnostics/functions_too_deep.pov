// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of functions of functions
#version 3.7;
#declare F = array[102];
#declare F[0] = function(x) { x }
#for (I, 1, 101) #declare Inner = F[I - 1]; #declare F[I] = function(x) { Inner(x) } #undef Inner #end
//! error: functions call each other more than 100 deep, which is the limit
//!  --> functions_too_deep.pov:6:61
//!   |
//! 6 | …r (I, 1, 101) #declare Inner = F[I - 1]; #declare F[I] = function(x) { Inner(x) } #undef Inner #end
//!   |                                                           ^^^^^^^^^^^^^^^^^^^^^^^^
//! help: it cannot be raised: write some of them out, or compute a part beforehand
