// SPDX-License-Identifier: GPL-3.0-or-later
// Signs in the wrong order
#version 3.7;
#declare A = 1; #if (A => 1) #debug "x" #end
