// SPDX-License-Identifier: GPL-3.0-or-later
// A file whose name has an equals sign
#version 3.7;
#include "size=2.inc"
