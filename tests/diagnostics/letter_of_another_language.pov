// SPDX-License-Identifier: GPL-3.0-or-later
// A letter that is not ASCII in a name
#version 3.7;
#declare Größe = 2;
sphere { 0, Größe }
