// SPDX-License-Identifier: GPL-3.0-or-later
// An array with too many elements
#version 3.7;
#declare A = array[1e6][1e6];
