// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has a blank
#version 3.7;
#include "my parts.inc"
