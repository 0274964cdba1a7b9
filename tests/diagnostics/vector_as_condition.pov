// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a condition
#version 3.7;
#if (<1, 0, 0>) sphere { 0, 1 } #end
