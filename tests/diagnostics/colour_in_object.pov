// SPDX-License-Identifier: GPL-3.0-or-later
// A colour without pigment
#version 3.7;
sphere { 0, 1 rgb <1, 0, 0> }
