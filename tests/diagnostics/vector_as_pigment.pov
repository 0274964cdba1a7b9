// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a pigment
#version 3.7;
sphere { 0, 1 pigment { <1, 0, 0> } }
