// SPDX-License-Identifier: GPL-3.0-or-later
// A path of another system
#version 3.7;
#include "lib\parts.inc"
