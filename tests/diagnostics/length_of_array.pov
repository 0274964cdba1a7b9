// SPDX-License-Identifier: GPL-3.0-or-later
// The size of an array by the wrong function
#version 3.7;
#declare A = array[3] {1,2,3} #declare N = length(A);
