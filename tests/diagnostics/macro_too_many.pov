// SPDX-License-Identifier: GPL-3.0-or-later
// An argument too many
#version 3.7;
#macro Lamp(Place)
    sphere { Place, 1 }
#end
Lamp(<0, 1, 0>, 2)
