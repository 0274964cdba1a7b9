// SPDX-License-Identifier: GPL-3.0-or-later
// A colour where a number is wanted
#version 3.7;
sphere { 0, 1 finish { diffuse rgb 1 } }
