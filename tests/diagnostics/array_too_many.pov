// SPDX-License-Identifier: GPL-3.0-or-later
// Values are left over
#version 3.7;
#declare A = array[2] { 1, 2, 3 }
