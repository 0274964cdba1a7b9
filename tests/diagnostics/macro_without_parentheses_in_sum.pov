// SPDX-License-Identifier: GPL-3.0-or-later
// A macro is no variable
#version 3.7;
#macro M() 3 #end
#declare C = M + 1;
