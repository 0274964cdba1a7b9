// SPDX-License-Identifier: GPL-3.0-or-later
// A colour of which only the first word is there
#version 3.7;
camera { location -5*z }
sphere { 0, 1 pigment { rgb } finish { emission 1 } }
