// SPDX-License-Identifier: GPL-3.0-or-later
// No such character
#version 3.7;
#declare A = chr(-1);
