// SPDX-License-Identifier: GPL-3.0-or-later
// An argument too few
#version 3.7;
#macro Lamp(Place, Size)
    sphere { Place, Size }
#end
Lamp(<0, 1, 0>)
