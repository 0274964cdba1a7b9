// SPDX-License-Identifier: GPL-3.0-or-later
// What is looked at without parentheses
#version 3.7;
#declare A = 1;
#switch A #case (1) #break #end
