// SPDX-License-Identifier: GPL-3.0-or-later
// An #end too many
#version 3.7;
#if (1) #end
#end
sphere { 0, 1 }
