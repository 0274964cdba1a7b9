// SPDX-License-Identifier: GPL-3.0-or-later
// A file that does not exist
#version 3.7;
#include "nothing_like_this.inc"
