// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the language as a parameter
#version 3.7;
#macro Lamp(radius)
    sphere { 0, radius }
#end
