// SPDX-License-Identifier: GPL-3.0-or-later
// A number with two points
#version 3.7;
#declare A = 1.2.3;
