// SPDX-License-Identifier: GPL-3.0-or-later
// An array of size 0
#version 3.7;
#declare A = array[0];
