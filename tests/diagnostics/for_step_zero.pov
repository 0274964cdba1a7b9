// SPDX-License-Identifier: GPL-3.0-or-later
// A step of 0
#version 3.7;
#for (I, 1, 3, 0)
    sphere { I, 1 }
#end
