// SPDX-License-Identifier: GPL-3.0-or-later
// scale <2, 1>
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 }
sphere { 0, 1 scale <2, 1> }
