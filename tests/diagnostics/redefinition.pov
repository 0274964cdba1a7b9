// SPDX-License-Identifier: GPL-3.0-or-later
// A macro cannot become a number
#version 3.7;
#macro Size() 1 #end
#declare Size = 2;
