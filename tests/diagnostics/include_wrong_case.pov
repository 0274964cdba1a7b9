// SPDX-License-Identifier: GPL-3.0-or-later
// Another case of letters
#version 3.7;
#include "Parts.inc"
