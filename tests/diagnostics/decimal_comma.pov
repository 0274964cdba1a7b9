// SPDX-License-Identifier: GPL-3.0-or-later
// A comma in a number
#version 3.7;
#declare A = 1,5;
