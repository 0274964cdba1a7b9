// SPDX-License-Identifier: GPL-3.0-or-later
// A map that is not in its pigment
#version 3.7;
sphere { 0, 1 color_map { [0 rgb 1] } }
