// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that does not exist
#version 3.7;
#macro Lamp(Place)
    sphere { Place, 1 }
#end
Lmap(0)
