// SPDX-License-Identifier: GPL-3.0-or-later
// A # before the name of what was declared
#version 3.7;
#declare Tower = union { sphere { 0, 1 } box { -1, <1, 0, 1> } }
object { #Tower scale 2 }
#Tower
#Tauer
