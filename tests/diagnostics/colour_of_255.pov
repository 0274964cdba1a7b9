// SPDX-License-Identifier: GPL-3.0-or-later
// Colours go from 0 to 1: legal, but bright
#version 3.7;
light_source { 0, rgb <255, 128, 0> }
sphere { 0, 1 pigment { rgb (1, 0, 0) } }
