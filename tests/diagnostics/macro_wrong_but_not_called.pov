// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong in a macro is told of where it is called, and only then
#version 3.7;
#macro Unused() sphere { 0, 1 +* 2 } #end
#macro Used(A) sphere { 0, A +* 2 } #end
Used(3)
