// SPDX-License-Identifier: GPL-3.0-or-later
// #macro of a word of the language, with directives inside
#version 3.7;
#macro sphere(R)
  #if (1) #declare A = 1; #end
#end
