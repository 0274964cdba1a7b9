// SPDX-License-Identifier: GPL-3.0-or-later
// A function with too few arguments
#version 3.7;
#declare A = atan2(1);
