// SPDX-License-Identifier: GPL-3.0-or-later
// Things without extent
#version 3.7;
camera { location y look_at y }
cylinder { 0, 0, 1 }
triangle { 0, x, 2*x }
sphere { 0, 1 scale <1, 0, 1> }
sphere { 0, 1 matrix <1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0> }
ovus { 0, 0 }
