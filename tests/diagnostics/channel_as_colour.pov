// SPDX-License-Identifier: GPL-3.0-or-later
// colour red
#version 3.7;
sphere { 0, 1 pigment { colour red } }
