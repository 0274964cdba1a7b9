// SPDX-License-Identifier: GPL-3.0-or-later
// A value without #declare
#version 3.7;
Radius = 2;
sphere { 0, Radius }
