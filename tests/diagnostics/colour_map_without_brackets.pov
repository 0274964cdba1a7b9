// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of a map without their brackets
#version 3.7;
sphere { 0, 1 pigment { gradient y color_map { 0 rgb 1, 1 rgb 0 } } }
