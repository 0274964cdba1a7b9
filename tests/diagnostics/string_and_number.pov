// SPDX-License-Identifier: GPL-3.0-or-later
// A number where a string is wanted
#version 3.7;
#declare I = 3;
#debug concat("frame ", I)
