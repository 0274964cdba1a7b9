// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter that is not used
#version 3.7;
#macro Lamp(Height, Size)
    sphere { 2*y, Size }
#end
Lamp(1, 2)
