// SPDX-License-Identifier: GPL-3.0-or-later
// A channel is no colour
#version 3.7;
sphere { 0, 1 pigment { red } }
