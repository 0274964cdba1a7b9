// SPDX-License-Identifier: GPL-3.0-or-later
// #if (A and B)
#version 3.7;
#declare A = 1;
#if (A and A) sphere { 0, 1 } #end
