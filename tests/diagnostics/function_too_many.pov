// SPDX-License-Identifier: GPL-3.0-or-later
// A function with too many arguments
#version 3.7;
#declare A = sin(1, 2);
