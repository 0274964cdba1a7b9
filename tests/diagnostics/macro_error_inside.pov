// SPDX-License-Identifier: GPL-3.0-or-later
// An error three macros deep
#version 3.7;
#macro Bulb(Size)
    sphere { 0, Size }
#end
#macro Lamp(Size)
    Bulb(Size)
#end
#macro Street(Size)
    #for (I, 1, 2)
        Lamp(Size)
    #end
#end
Street("big")
