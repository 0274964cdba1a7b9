// SPDX-License-Identifier: GPL-3.0-or-later
// An expression where a function is wanted
#version 3.7;
isosurface { x*x + y*y - 1 }
