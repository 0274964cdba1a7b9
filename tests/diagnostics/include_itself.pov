// SPDX-License-Identifier: GPL-3.0-or-later
// A file that includes itself
#version 3.7;
#include "itself.inc"
