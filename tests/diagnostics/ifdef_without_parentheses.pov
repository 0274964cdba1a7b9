// SPDX-License-Identifier: GPL-3.0-or-later
// #ifdef Name ... #end
#version 3.7;
#ifdef Foo sphere { 0, 1 } #end
