// SPDX-License-Identifier: GPL-3.0-or-later
// A scale of 0
#version 3.7;
sphere { 0, 1 scale <1, 0, 1> }
