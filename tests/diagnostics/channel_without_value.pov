// SPDX-License-Identifier: GPL-3.0-or-later
// A channel without its value
#version 3.7;
sphere { 0, 1 pigment { color red 1 green } }
