// SPDX-License-Identifier: GPL-3.0-or-later
// An #else without #if
#version 3.7;
#else
sphere { 0, 1 }
