// SPDX-License-Identifier: GPL-3.0-or-later
// A condition without parentheses
#version 3.7;
#declare I = 2;
#if I > 1 sphere { 0, 1 } #end
