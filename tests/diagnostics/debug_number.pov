// SPDX-License-Identifier: GPL-3.0-or-later
// #debug of a number
#version 3.7;
#declare I = 3;
#debug I
