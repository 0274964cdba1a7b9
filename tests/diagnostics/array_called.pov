// SPDX-License-Identifier: GPL-3.0-or-later
// An index in parentheses
#version 3.7;
#declare A = array[3] { 1, 2, 3 } #declare B = A(1);
