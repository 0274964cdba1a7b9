// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a file without quotes
#version 3.7;
sphere { 0, 1 pigment { image_map { png Wreath.png } } }
