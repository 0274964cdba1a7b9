// SPDX-License-Identifier: GPL-3.0-or-later
// The #end of the inner #if is missing
#version 3.7;
#for (I, 1, 3)
    #if (I > 1)
        sphere { I, 1 }
#end
box { 0, 1 }
