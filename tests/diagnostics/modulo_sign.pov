// SPDX-License-Identifier: GPL-3.0-or-later
// a % b
#version 3.7;
#declare A = 7 % 2;
