// SPDX-License-Identifier: GPL-3.0-or-later
// i++
#version 3.7;
#declare I = 0;
#while (I < 3)
    I++;
#end
