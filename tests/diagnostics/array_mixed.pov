// SPDX-License-Identifier: GPL-3.0-or-later
// Two kinds in an array
#version 3.7;
#declare A = array[2] { 1, "two" }
