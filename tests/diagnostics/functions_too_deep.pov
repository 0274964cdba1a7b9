// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of functions of functions
#version 3.7;
#declare F = array[102];
#declare F[0] = function(x) { x }
#for (I, 1, 101) #declare Inner = F[I - 1]; #declare F[I] = function(x) { Inner(x) } #undef Inner #end
