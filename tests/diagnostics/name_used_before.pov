// SPDX-License-Identifier: GPL-3.0-or-later
// Used before it is declared
#version 3.7;
sphere { 0, Radius }
#declare Radius = 1;
