// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that never ends
#version 3.7;
#declare I = 0;
#while (I < 10)
    sphere { I*x, 1 }
#end
