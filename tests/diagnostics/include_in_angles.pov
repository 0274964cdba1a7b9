// SPDX-License-Identifier: GPL-3.0-or-later
// #include <colors.inc>
#version 3.7;
#include <colors.inc>
sphere { 0, 1 pigment { Red } }
