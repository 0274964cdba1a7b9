// SPDX-License-Identifier: GPL-3.0-or-later
// A light with a texture
#version 3.7;
light_source { y, rgb 1 pigment { rgb 1 } }
