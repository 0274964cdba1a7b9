// SPDX-License-Identifier: GPL-3.0-or-later
// The newest version behind another statement
#declare A = 1;
#version 3.8;
sphere { 0, 1 }
