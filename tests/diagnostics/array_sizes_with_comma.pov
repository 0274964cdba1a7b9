// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes side by side
#version 3.7;
#declare A = array[3,4];
