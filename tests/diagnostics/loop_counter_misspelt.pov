// SPDX-License-Identifier: GPL-3.0-or-later
// The counter of a loop
#version 3.7;
#for (I, 1, 3)
    sphere { <J, 0, 0>, 1 }
#end
