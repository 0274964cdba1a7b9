// SPDX-License-Identifier: GPL-3.0-or-later
// The size of an array as in other languages
#version 3.7;
#declare A = array[3] {1,2,3} #declare N = A.length;
