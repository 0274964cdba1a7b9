// SPDX-License-Identifier: GPL-3.0-or-later
// A colour straight in a texture
#version 3.7;
sphere { 0, 1 texture { rgb <1,0,0> } }
