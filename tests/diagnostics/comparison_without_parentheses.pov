// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison outside of parentheses
#version 3.7;
#declare A = 1 < 2;
