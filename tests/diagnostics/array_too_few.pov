// SPDX-License-Identifier: GPL-3.0-or-later
// Values are missing
#version 3.7;
#declare A = array[3] { 1, 2 }
