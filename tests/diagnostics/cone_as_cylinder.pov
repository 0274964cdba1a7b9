// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of the base comes before the cap
#version 3.7;
cone { <0,0,0>, <0,1,0>, 1, 0 }
