// SPDX-License-Identifier: GPL-3.0-or-later
// The word of other languages
#version 3.7;
#if (1 > 2)
#elif (1)
    sphere { 0, 1 }
#end
