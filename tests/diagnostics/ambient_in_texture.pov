// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the finish in the texture
#version 3.7;
sphere { 0, 1 texture { pigment { rgb 1 } ambient 0.5 } }
