// SPDX-License-Identifier: GPL-3.0-or-later
// Infinity as a radius
#version 3.7;
sphere { 0, 1 / 0 }
