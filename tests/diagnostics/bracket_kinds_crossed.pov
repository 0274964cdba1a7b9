// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets of two kinds
#version 3.7;
#declare A = array[2} { 1, 2 };
