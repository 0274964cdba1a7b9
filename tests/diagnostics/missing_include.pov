// SPDX-License-Identifier: GPL-3.0-or-later
// A file that is not there
#version 3.7;
#include "colours.inc"
sphere { 0, 1 }
