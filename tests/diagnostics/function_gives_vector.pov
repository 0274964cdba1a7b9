// SPDX-License-Identifier: GPL-3.0-or-later
// A function gives a number
#version 3.7;
#declare F = function { <x,y,z> }
