// SPDX-License-Identifier: GPL-3.0-or-later
// checker of colours without colors.inc
#version 3.7;
plane { y, 0 pigment { checker Red, White } }
