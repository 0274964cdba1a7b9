// SPDX-License-Identifier: GPL-3.0-or-later
// Too many components of a colour
#version 3.7;
sphere { 0, 1 pigment { rgb <1, 2, 3, 4, 5, 6> } }
