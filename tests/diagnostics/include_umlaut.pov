// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has letters beyond ASCII
#version 3.7;
#include "grün.inc"
