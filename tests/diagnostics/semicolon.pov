// SPDX-License-Identifier: GPL-3.0-or-later
// A declaration of a number without its semicolon
#version 3.7;
#declare Radius = 2
sphere { 0, Radius }
