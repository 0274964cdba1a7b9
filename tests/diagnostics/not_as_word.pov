// SPDX-License-Identifier: GPL-3.0-or-later
// #if (not I)
#version 3.7;
#declare I = 1;
#if (not I) sphere { 0, 1 } #end
