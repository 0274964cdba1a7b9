// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has a per cent sign
#version 3.7;
#include "100%.inc"
