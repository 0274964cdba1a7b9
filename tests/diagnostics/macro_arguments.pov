// SPDX-License-Identifier: GPL-3.0-or-later
// Macros called with too few and too many arguments
#version 3.7;
#macro Lamp(Place, Size)
    sphere { Place, Size }
#end
Lamp(<0, 1, 0>)
Lamp(<0, 1, 0>, 1, 2)
