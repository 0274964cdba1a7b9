// SPDX-License-Identifier: GPL-3.0-or-later
// An array where a number is wanted
#version 3.7;
#declare A = array[2] { 1, 2 }
sphere { 0, A }
